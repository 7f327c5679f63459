// Elements made from text. What a recording says goes in as text and never as markup, so a scene may be
// called anything.

function make(name, attributes = {}, ...children) {
  return fill(document.createElement(name), attributes, children);
}

// The same for the elements of a drawing (SVG).
function draw(name, attributes = {}, ...children) {
  return fill(document.createElementNS("http://www.w3.org/2000/svg", name), attributes, children);
}

// Attributes that are null, undefined or false are left out; onclick and its like are listened to.
function fill(element, attributes, children) {
  for (const [key, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (key.startsWith("on")) element.addEventListener(key.slice(2), value);
    else element.setAttribute(key, value === true ? "" : value);
  }
  element.append(...children.flat(3).filter((child) => child !== null && child !== undefined));
  return element;
}

// A button that reads like a link: it changes what the page shows.
function linkTo(text, action, title = null) {
  return make("button", {type: "button", class: "link", title, onclick: action}, text);
}

function paragraph(...children) {
  return make("p", {}, ...children);
}

// A table with a header row. Numbers are cells of the class "number".
function table(header, rows, attributes = {}) {
  const isNumber = (content) => /^[-−+]?[\d.]/.test(content?.nodeName === "DATA" ? content.textContent : content);
  const cell = (content) => make("td", {class: isNumber(content) ? "number" : null}, content);
  return make("table", attributes,
    make("thead", {}, make("tr", {}, header.map((text) => make("th", {scope: "col"}, text)))),
    make("tbody", {}, rows.map((row) => make("tr", {}, row.map(cell)))));
}

// Opens and closes by keyboard too.
function folded(summary, ...children) {
  return make("details", {}, make("summary", {}, summary), ...children);
}

function plural(count, one, many = one + "s") {
  return `${wholeNumber(count)} ${count === 1 ? one : many}`;
}
