// Elements of the page: finding them and making them.

/**
 * @param {string} id
 * @returns {HTMLElement}
 */
export function byId(id) {
    const found = document.getElementById(id);
    if (!found) throw new Error(`the page has no element '${id}'`);
    return found;
}

/**
 * An element with a class of its own.
 * @template {Element} T
 * @param {string} id
 * @param {new () => T} type
 * @returns {T}
 */
export function typed(id, type) {
    const found = byId(id);
    if (!(found instanceof type)) throw new Error(`the element '${id}' is no ${type.name}`);
    return found;
}

/**
 * Makes an element. An attribute that is false is left out; one that is true has no value.
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} name
 * @param {Record<string, string | boolean>} attributes
 * @param {...(Node | string)} children
 * @returns {HTMLElementTagNameMap[K]}
 */
export function element(name, attributes, ...children) {
    const made = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) {
        if (value !== false) made.setAttribute(key, value === true ? "" : value);
    }
    made.append(...children);
    return made;
}

let made = 0;

/** An id that no other element has. */
export function newId() {
    made += 1;
    return `made-${made}`;
}

/**
 * Makes the children of a parent these, in this order. Children that stay are not moved, so that they keep
 * the focus.
 * @param {Element} parent
 * @param {Element[]} wanted
 */
export function reconcile(parent, wanted) {
    const stay = new Set(wanted);
    for (const child of [...parent.children]) {
        if (!stay.has(child)) child.remove();
    }
    let next = parent.firstElementChild;
    for (const child of wanted) {
        if (child === next) next = child.nextElementSibling;
        else parent.insertBefore(child, next);
    }
}
