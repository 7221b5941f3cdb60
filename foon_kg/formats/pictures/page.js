const act = stage(document.getElementById("stage"));
for (const button of document.querySelectorAll("[data-do]")) button.addEventListener("click", act[button.dataset.do]);
