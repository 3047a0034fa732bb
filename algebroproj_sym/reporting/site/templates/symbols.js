"use strict";

// A symbol opens its card beside it.  The cards of a paper are one script, which is loaded when the first one is asked for.
const links = document.querySelectorAll(".symbols a");
const nameOf = new Map([...links].map((link) => [link.textContent.trim(), link.hash.slice(1)]));
const card = document.createElement("div");
card.className = "card";
card.popover = "auto";
document.querySelector(".symbols").after(card);

let loading;
const loaded = () => (loading ??= new Promise((resolve) => {
  const script = document.createElement("script");
  script.src = new URL("cards.js", links[0].href);
  script.onload = () => resolve(SYMBOLS);
  document.head.append(script);
}));

async function open(name, anchor) {
  card.innerHTML = (await loaded())[name];
  if (!card.matches(":popover-open")) card.showPopover();
  const { left, bottom } = anchor.getBoundingClientRect();
  card.style.margin = 0;
  card.style.left = `${Math.max(8, Math.min(left, innerWidth - card.offsetWidth - 8))}px`;
  card.style.top = `${Math.min(bottom + 6, Math.max(8, innerHeight - card.offsetHeight - 8))}px`;
}

for (const link of links) {
  link.addEventListener("click", (event) => {
    if (event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    open(nameOf.get(link.textContent.trim()), link);
  });
}

for (const symbol of document.querySelectorAll("main math :is(msub, msup, msubsup, mi)")) {
  const name = nameOf.get(symbol.textContent.trim());
  if (!name || symbol.closest(".symbols, .card") || symbol.parentElement.closest(".known")) continue;
  symbol.classList.add("known");
  symbol.addEventListener("click", () => open(name, symbol));
}
