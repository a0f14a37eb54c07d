// What the page and every host share: the errors of a host, and numbers of drags and drops.

/** The host refused a request and said why. Nothing has changed. */
export class Refused extends Error {}

/** Another change ended the request: ask again. */
export class Outdated extends Error {}

/** The host does not answer. */
export class Gone extends Error {
    constructor() {
        super("The program has ended. Start `relief view` again.");
    }
}

/** A number for a group of requests. It also differs from the numbers of pages opened earlier. */
let last = Date.now() * 1000;
export function newNumber() {
    last += 1;
    return last;
}
