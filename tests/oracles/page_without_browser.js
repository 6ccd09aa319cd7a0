// Runs the programs of a report in Node.js, with a document that draws nothing but notes what is drawn.
// Usage: node page_without_browser.js page.html; prints one JSON object.

const fs = require("fs");
const vm = require("vm");

const page = fs.readFileSync(process.argv[2], "utf8");
const data = page.match(/<script type="application\/json" id="data">(.*?)<\/script>/s)[1];
const program = page.match(/<script>\n("use strict";.*)<\/script>/s)[1];

// A pen that notes the colour and width of each stroke and fill.
const drawn = [];
const pen = new Proxy({}, {
  get: (state, name) => (name in state ? state[name] : () => {
    if (name === "stroke") drawn.push(["stroke", state.strokeStyle, state.lineWidth]);
    if (name === "fill") drawn.push(["fill", state.fillStyle]);
  }),
  set: (state, name, value) => { state[name] = value; return true; },
});

class Element {
  constructor() {
    Object.assign(this, { children: [], attributes: {}, style: {}, dataset: {}, hidden: false, textContent: "" });
    this.classList = { toggle() {} };
  }

  getBoundingClientRect() { return { width: 600, height: 400, left: 0, top: 0 }; }
  getContext() { return pen; }
  addEventListener() {}
  setAttribute(name, value) { this.attributes[name] = value; }
  removeAttribute() {}
  append(...children) { this.children.push(...children); }
  replaceChildren(...children) { this.children = children; }
  prepend(...children) { this.children.unshift(...children); }
  closest() { return new Element(); }
  querySelector() { return new Element(); }
  contains() { return false; }
}

const elements = {};
const getElementById = (id) => (elements[id] ??= new Element());
getElementById("data").textContent = data;
const documentElement = new Element();
const window = {};
vm.runInNewContext(program, {
  document: { getElementById, documentElement, createElement: () => new Element(), createElementNS: () => new Element() },
  window, console, URLSearchParams, DecompressionStream, Blob, Response, setTimeout, clearTimeout, addEventListener() {},
  atob: (text) => Buffer.from(text, "base64").toString("binary"),
  getComputedStyle: () => ({ getPropertyValue: (name) => name.slice(2) }),
  matchMedia: () => ({ matches: true, addEventListener() {} }),
  Path2D: class { rect() {} },
  ResizeObserver: class { observe() {} },
  requestAnimationFrame() {},
  history: { replaceState() {}, pushState() {} },
  location: { hash: "" },
});

async function ready() {
  while (documentElement.dataset.ready !== "yes") await new Promise((done) => setTimeout(done, 5));
  const { stage, state, map } = window.stridemap;
  drawn.length = 0;
  stage.walker(pen, (point) => point, 100);
  const walker = [...drawn];
  const texts = {};
  for (const { attributes } of elements.colour.children) {
    elements.colour.onchange.call(null, (elements.colour.value = attributes.value));
    texts[attributes.value] = [state.colour, elements["slice-name"].textContent, map.looks.flat().length];
  }
  console.log(JSON.stringify({
    ready: documentElement.dataset.ready, walker, texts, closing: stage.path.closing, now: elements.now.textContent,
  }));
}

ready();
