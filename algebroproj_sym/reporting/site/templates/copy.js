"use strict";

// Buttons that copy a text, or the address of the page if they have none.
for (const line of document.querySelectorAll(".copies")) {
  line.hidden = false;
  const status = line.querySelector("[role=status]");
  for (const button of line.querySelectorAll("[data-copy]")) {
    button.addEventListener("click", async () => {
      const text = button.dataset.copy || location.href;
      try {
        await navigator.clipboard.writeText(text);
        status.textContent = "Copied.";
      } catch {
        status.textContent = text;
      }
    });
  }
}
