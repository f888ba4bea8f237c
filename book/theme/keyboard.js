// What mdBook leaves to the mouse, for those who use the keyboard or a screen reader.

// The button for the table of contents is a <label>.
const contents = document.getElementById("mdbook-sidebar-toggle");
if (contents) {
    contents.setAttribute("role", "button");
    contents.tabIndex = 0;
    contents.addEventListener("keydown", (event) => {
        if (event.key === "Enter" || event.key === " ") {
            event.preventDefault();
            contents.click();
        }
    });
}

// What is wider than its column scrolls; the arrow keys need it focused.
const reach = () => document.querySelectorAll("pre > code, .table-wrapper").forEach((part) => {
    if (part.scrollWidth > part.clientWidth) part.tabIndex = 0;
    else part.removeAttribute("tabindex");
});
reach();
addEventListener("resize", reach);
document.addEventListener("toggle", reach, true);
document.fonts.ready.then(reach);
