"use strict";

// The edges of a vertex stand out while the pointer or the focus is on it.
const graph = document.querySelector(".graph");
const mark = (event) => {
  const vertex = event.target.closest("[data-vertex]")?.dataset.vertex;
  for (const edge of graph.querySelectorAll("path")) {
    edge.classList.toggle("near", vertex !== undefined && [edge.dataset.from, edge.dataset.to].includes(vertex));
  }
};
for (const kind of ["pointerover", "focusin", "focusout"]) graph.addEventListener(kind, mark);
