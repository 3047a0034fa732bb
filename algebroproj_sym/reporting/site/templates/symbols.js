"use strict";

// A symbol of a formula opens the card that the button with the same symbol opens, beside the place of the event.
const cards = new Map();
let anchor;
for (const button of document.querySelectorAll("[popovertarget]")) {
  const card = document.getElementById(button.getAttribute("popovertarget"));
  cards.set(button.textContent.trim(), card);
  button.addEventListener("click", () => { anchor = button; });
  card.addEventListener("toggle", ({ newState }) => { if (newState === "open") place(card, anchor.getBoundingClientRect()); });
}

function place(card, { left, bottom }) {
  card.style.margin = 0;
  card.style.left = `${Math.max(8, Math.min(left, innerWidth - card.offsetWidth - 8))}px`;
  card.style.top = `${Math.min(bottom + 6, Math.max(8, innerHeight - card.offsetHeight - 8))}px`;
}

function symbolAt(element) {
  for (let each = element; each?.closest("math"); each = each.parentElement) {
    const card = cards.get(each.textContent.trim());
    if (card) return [card, each];
  }
  return [];
}

const main = document.querySelector("main");
main.addEventListener("click", (event) => {
  const [card, symbol] = symbolAt(event.target);
  if (!card || symbol.closest("button, [popover]")) return;
  anchor = symbol;
  card.showPopover();
});
for (const symbol of main.querySelectorAll("math :is(msub, msup, msubsup, mi)")) {
  if (cards.has(symbol.textContent.trim())) symbol.classList.add("known");
}
