// A picture of a document that can be turned: <relief-figure> over an <img>.
//
//     <script type="module" src="relief/relief-figure.js"></script>
//     <relief-figure scene="scenes/wall.toml" controls="method,search.steps">
//         <img src="wall.jpg" alt="A wall">
//     </relief-figure>
//
// The picture alone is loaded until somebody starts the figure.

/** The module that all figures of the page share, once one of them has started. */
const live = () => import("./figure_live.js");

class ReliefFigure extends HTMLElement {
    #start = document.createElement("button");
    #said = document.createElement("p");
    #frame = document.createElement("div");

    connectedCallback() {
        if (this.shadowRoot) return;
        const root = this.attachShadow({ mode: "open" });
        const style = document.createElement("link");
        style.rel = "stylesheet";
        style.href = new URL("figure.css", import.meta.url).href;
        this.#frame.className = "frame";
        this.#start.type = "button";
        this.#start.className = "start";
        this.#start.textContent = this.getAttribute("start") ?? "Turn";
        const title = this.querySelector("img")?.alt;
        if (title) this.#start.setAttribute("aria-label", `${this.#start.textContent}: ${title}`);
        this.#said.setAttribute("role", "alert");
        this.#frame.append(document.createElement("slot"), this.#start);
        root.append(style, this.#frame, this.#said);
        this.#start.addEventListener("click", () => this.#begin());
    }

    async #begin() {
        this.#start.disabled = true;
        this.#said.textContent = "";
        this.#frame.classList.add("waits");
        try {
            const { show } = await live();
            await show(this, this.#frame);
            this.#start.remove();
        } catch (error) {
            // The still picture stays.
            this.#start.disabled = false;
            this.#said.textContent = error instanceof Error ? error.message : String(error);
        } finally {
            this.#frame.classList.remove("waits");
        }
    }
}

customElements.define("relief-figure", ReliefFigure);
