"use strict";

// Entries of SEARCH_INDEX: address, where, number or name, title, verdict, symbols.
const MOST = 200;

const plain = (text) => text.toLowerCase().replace(/[′’]/g, "'");

function score(entry, words) {
  const number = plain(entry[2]);
  const title = plain(entry[3]);
  const symbols = plain(entry[5]).split(" ");
  const rest = plain(`${entry[1]} ${entry[4]}`);
  let total = 0;
  for (const word of words) {
    const bare = word.replace(/^\(|\)$/g, "");
    if (number === bare) total += 100;
    else if (number.startsWith(bare)) total += 40;
    else if (symbols.includes(bare)) total += 20;
    else if (title.includes(bare)) total += 10;
    else if (number.includes(bare) || rest.includes(bare)) total += 5;
    else return 0;
  }
  return total;
}

function search(index, query) {
  const words = plain(query).split(/\s+/).filter(Boolean);
  if (words.length === 0) return [];
  return index
    .map((entry, place) => ({ entry, place, points: score(entry, words) }))
    .filter((hit) => hit.points > 0)
    .sort((a, b) => b.points - a.points || a.place - b.place)
    .map((hit) => hit.entry);
}

function item([address, where, number, title, verdict]) {
  const line = document.createElement("li");
  const link = document.createElement("a");
  link.href = address;
  link.textContent = where === "function" ? number : `(${number})`;
  line.append(link, ` ${title}`);
  if (verdict) {
    const badge = document.createElement("span");
    badge.className = `verdict ${verdict}`;
    badge.textContent = verdict;
    line.append(" ", badge);
  }
  const source = document.createElement("span");
  source.className = "quiet";
  source.textContent = ` ${where}`;
  line.append(source);
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
