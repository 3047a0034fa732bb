"use strict";

// Entries of SEARCH_INDEX: address, where, number or name, title, verdict, symbols.
const MOST = 200;

const plain = (text) => text.toLowerCase().replace(/[′’]/g, "'");

const GREEK = {
  α: "alpha", β: "beta", γ: "gamma", δ: "delta", ε: "eps", ζ: "zeta", η: "eta", θ: "theta", κ: "kappa", λ: "lambda",
  μ: "mu", ν: "nu", ξ: "xi", ρ: "rho", σ: "sigma", τ: "tau", φ: "phi", χ: "chi", ψ: "psi", ω: "omega",
};
const latin = (text) => text.replace(/[α-ω]/g, (letter) => GREEK[letter] ?? letter).replace(/[_{}\\]/g, "");

// Whether one letter more, less or different, or two exchanged, makes one word of the other.
function isNear(word, other) {
  if (word === other) return true;
  if (word.length < 4 || Math.abs(word.length - other.length) > 1 || /\d/.test(word)) return false;
  let start = 0;
  while (start < word.length && word[start] === other[start]) start += 1;
  const [left, right] = [word.slice(start), other.slice(start)];
  const exchanged = left[1] + left[0] + left.slice(2);
  return [left.slice(1) === right.slice(1), left === right.slice(1), left.slice(1) === right, exchanged === right].some(Boolean);
}

function score(entry, words, isClose) {
  const number = plain(entry[2]);
  const title = plain(entry[3]);
  const symbols = latin(plain(entry[5])).split(" ");
  const rest = plain(`${entry[1]} ${entry[4]}`);
  let total = 0;
  for (const word of words) {
    const bare = word.replace(/^\(|\)$/g, "");
    if (number === bare) total += 100;
    else if (number.startsWith(bare)) total += 40;
    else if (symbols.includes(latin(bare))) total += 20;
    else if (title.startsWith(bare)) total += 12;
    else if (title.includes(bare)) total += 10;
    else if (number.includes(bare) || rest.includes(bare)) total += 5;
    else if (isClose && title.split(/\W+/).some((other) => isNear(bare, other))) total += 1;
    else return 0;
  }
  return total;
}

function search(index, query) {
  const words = plain(query).split(/\s+/).filter(Boolean);
  if (words.length === 0) return [];
  const hits = (isClose) => index
    .map((entry, place) => ({ entry, place, points: score(entry, words, isClose) }))
    .filter((hit) => hit.points > 0)
    .sort((a, b) => b.points - a.points || a.place - b.place)
    .map((hit) => hit.entry);
  const exact = hits(false);
  return exact.length > 0 ? exact : hits(true);
}

function span(name, ...content) {
  const element = document.createElement("span");
  element.className = name;
  element.append(...content);
  return element;
}

function item([address, where, number, title, verdict]) {
  const line = document.createElement("li");
  const link = document.createElement("a");
  link.href = address;
  link.textContent = ["function", "paper"].includes(where) ? number : `(${number})`;
  line.append(link, span(verdict && `verdict ${verdict}`, verdict), span("title", `${title} `, span("quiet", where)));
  return line;
}

function show(query) {
  const hits = search(SEARCH_INDEX, query);
  document.getElementById("results").replaceChildren(...hits.slice(0, MOST).map(item));
  const shown = hits.length > MOST ? `, the first ${MOST} of them here` : "";
  document.getElementById("found").textContent = query.trim() ? `${hits.length} found${shown}.` : "";
}

if (typeof document !== "undefined") {
  const field = document.getElementById("query");
  field.value = new URLSearchParams(location.search).get("q") ?? "";
  if (field.value) show(field.value);
  field.addEventListener("input", () => show(field.value));
  field.form.addEventListener("submit", (event) => {
    event.preventDefault();
    show(field.value);
  });
} else {
  module.exports = { search };
}
