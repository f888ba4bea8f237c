// Looks at every page of the built book in headless Chromium, in two widths and both themes.
//
//     npm ci && node check.js [FOLDER]     FOLDER: the book, by default target/book
//
// It fails on a console error, a request for anything but the book's own files, words or figures wider than their column, code that
// is cut, scrolls or is squeezed, what scrolls and does not show it, letters of a figure too small to read, a serious finding of
// axe-core, and a search that finds nothing.

import { existsSync, readFileSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { launch } from "./launch.js";

const here = dirname(fileURLToPath(import.meta.url));
const book = resolve(process.argv[2] ?? join(here, "../../target/book"));
if (!existsSync(join(book, "index.html"))) {
    console.error(`${book}: there is no book here; cargo run -p book builds it`);
    process.exit(1);
}
const root = pathToFileURL(book).href + "/";
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

const widths = [390, 1280];
const themes = ["light", "dark"];
/// The least height of letters in a line drawing, in CSS pixels, as shown.
const smallest = 10;

// toc.html is shown where scripts are off, 404.html by servers under other addresses.
const pages = readdirSync(book).filter((name) => name.endsWith(".html") && !["toc.html", "404.html"].includes(name));
const faults = [];

const browser = await launch();
for (const colorScheme of themes) {
    for (const width of widths) {
        const context = await browser.newContext({ viewport: { width, height: 900 }, colorScheme });
        for (const name of pages) {
            await look(context, name, `${name}, ${width} px, ${colorScheme}`, width, colorScheme);
        }
        await context.close();
    }
}
await search();
await browser.close();

for (const fault of faults) console.error(fault);
console.log(`${pages.length} pages, ${widths.length} widths, ${themes.length} themes: ${faults.length} faults`);
process.exit(faults.length ? 1 : 0);

/// Opens a page and notes what is wrong with it.
async function look(context, name, where, width, colorScheme) {
    const page = await context.newPage();
    const fault = (text) => faults.push(`${where}: ${text}`);
    page.on("console", (message) => message.type() === "error" && fault(message.text()));
    page.on("pageerror", (error) => fault(`script: ${error.message}`));
    page.on("request", (request) => request.url().startsWith(root) || request.url().startsWith("data:")
        || fault(`asks for ${request.url()}`));
    page.on("requestfailed", (request) => fault(`cannot load ${request.url()}`));
    // The page of all chapters is large, and the machine may have other things to do.
    await page.goto(root + name, { waitUntil: "load", timeout: 120_000 });
    await page.evaluate(() => document.fonts.ready);
    const theme = await page.evaluate(() => document.documentElement.classList.contains("navy"));
    if (theme !== (colorScheme === "dark")) fault("shows the wrong theme");
    // Folded parts must fit as well.
    await page.evaluate(() => document.querySelectorAll("details").forEach((part) => { part.open = true; }));
    (await page.evaluate(measure)).forEach(fault);
    await drawings(page, fault);
    // The printed page is all others in one: its findings would be theirs again.
    if (name !== "print.html") await accessibility(page, fault);
    await page.close();
}

/// Runs in the page: what is wider than its column, and what did not load.
function measure() {
    const found = [];
    const main = document.querySelector("main");
    const column = main.getBoundingClientRect();
    const scrolls = (element) => {
        for (let part = element; part && part !== main; part = part.parentElement) {
            if (["auto", "scroll", "hidden"].includes(getComputedStyle(part).overflowX)) return true;
        }
        return false;
    };
    if (document.documentElement.scrollWidth > innerWidth) found.push("scrolls sideways");
    for (const element of main.querySelectorAll("*")) {
        const box = element.getBoundingClientRect();
        if (box.width && (box.right > column.right + 1 || box.left < column.left - 1) && !scrolls(element.parentElement)) {
            found.push(`<${element.tagName.toLowerCase()}> is wider than its column: ${element.textContent.trim().slice(0, 60)}`);
        }
    }
    for (const code of main.querySelectorAll("pre > code")) {
        if (code.scrollWidth > code.clientWidth + 1) found.push(`code is cut: ${code.textContent.trim().slice(0, 60)}`);
    }
    for (const code of main.querySelectorAll(".quote > pre > code")) {
        if (code.offsetWidth < code.parentElement.clientWidth - 1) {
            found.push(`a listing is squeezed: ${code.textContent.trim().slice(0, 60)}`);
        }
    }
    for (const element of main.querySelectorAll(".formula, .table-wrapper, figure > a")) {
        const { backgroundImage } = getComputedStyle(element);
        if (element.scrollWidth > element.clientWidth + 1 && !backgroundImage.includes("gradient")) {
            found.push(`nothing shows that this scrolls: ${element.textContent.trim().slice(0, 60)}`);
        }
    }
    for (const image of main.querySelectorAll("img")) {
        if (!image.complete || !image.naturalWidth) found.push(`${image.getAttribute("src")} is no picture`);
        if (!image.alt.trim()) found.push(`${image.getAttribute("src")} has no words for who cannot see it`);
    }
    if (/\{\{|\$\$/.test(main.innerText.replace(/`[^`]*`/g, "")) && !main.querySelector("code")) found.push("shows raw marks");
    const parts = { mfrac: 2, mover: 2, mroot: 2, msub: 2, msubsup: 3, msup: 2, munder: 2, munderover: 3 };
    for (const formula of main.querySelectorAll(Object.keys(parts).join())) {
        if (formula.children.length !== parts[formula.localName]) found.push(`a broken formula: ${formula.outerHTML.slice(0, 90)}`);
    }
    if (main.querySelector("merror")) found.push("shows a broken formula");
    return found.slice(0, 8);
}

/// Letters in line drawings, at the size at which they are shown.
async function drawings(page, fault) {
    const shown = await page.evaluate(() => [...document.querySelectorAll("figure.figure > img[src$='.svg'], .live-drawing > svg")]
        .filter((drawing) => drawing.getClientRects().length)
        .map((drawing) => [drawing.getAttribute("src"), drawing.outerHTML, drawing.getBoundingClientRect().width]));
    for (const [source, html, width] of shown) {
        const svg = source ? readFileSync(join(book, source), "utf8") : html;
        const [, , wide] = svg.match(/viewBox="([\d.]+ ){2}([\d.]+)/);
        const letters = [...svg.matchAll(/font-size="([\d.]+)"/g)].map((match) => Number(match[1]));
        const height = Math.min(...letters) * width / Number(wide);
        if (height < smallest) fault(`${source ?? "a figure that moves"}: letters of ${height.toFixed(1)} px`);
    }
}

/// The findings of axe-core that it calls serious or critical.
async function accessibility(page, fault) {
    await page.evaluate(axe);
    const { violations } = await page.evaluate(() => window.axe.run(document, { resultTypes: ["violations"], preload: false }));
    for (const { id, impact, help, nodes } of violations) {
        if (["serious", "critical"].includes(impact)) {
            fault(`axe, ${impact}, ${id}: ${help}: ${nodes.slice(0, 3).map((node) => node.html.slice(0, 120)).join(" | ")}`);
        }
    }
}

/// The search must work on files, with no server.
async function search() {
    const page = await browser.newPage();
    await page.goto(root + "index.html");
    await page.click("#mdbook-search-toggle");
    await page.locator("#mdbook-searchbar").pressSequentially("bresenham");
    const hit = page.locator("#mdbook-searchresults a").first();
    await hit.waitFor({ timeout: 10_000 }).catch(() => faults.push("index.html: the search finds no `bresenham`"));
    await page.close();
}
