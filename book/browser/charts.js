// Asks every chart of the built book, in headless Chromium, or in Firefox with BROWSER=firefox, from files.
//
//     npm ci && node charts.js [FOLDER] [PICTURES]     FOLDER: the book, by default target/book
//
// It fails where a chart does not answer: where a mark, reached by keys or pointed at, tells other numbers than the measured table
// or the table beside it; where a method that is switched off stays or does not come back; where the slider tells nothing else;
// where a chart is missing in print or without scripts, or a request leaves the book. Pictures of all charts, one method off and
// a mark told, are written to PICTURES, if there is such a folder.

import { existsSync, readFileSync, readdirSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { inFirefox, launch } from "./launch.js";

const here = dirname(fileURLToPath(import.meta.url));
const book = resolve(process.argv[2] ?? join(here, "../../target/book"));
const pictures = process.argv[3];
if (!existsSync(join(book, "index.html"))) {
    console.error(`${book}: there is no book here; cargo run -p book builds it`);
    process.exit(1);
}
const root = pathToFileURL(book).href + "/";
/// Of these pages alone, as 01: PAGE=01 node charts.js
const only = process.env.PAGE ?? "";
const pages = readdirSync(book).filter((name) => name.startsWith(only) && name.endsWith(".html") && name !== "print.html"
    && readFileSync(join(book, name), "utf8").includes('<figure class="chart"'));

const faults = new Set();
const count = { charts: 0, marks: 0, tables: 0, sliders: 0 };
const browser = await launch();
// The pages' style and script are the same.
if (!inFirefox) await withoutScript(pages[0]);
for (const name of pages) await look(name);
await browser.close();

for (const fault of faults) console.error(fault);
console.log(`${count.charts} charts, each in 2 widths, ${count.marks} marks, ${count.tables} rows of tables beside, `
    + `${count.sliders} sliders: ${faults.size} faults`);
process.exit(faults.size ? 1 : 0);

/// Without scripts the still charts are there.
async function withoutScript(name) {
    const context = await browser.newContext({ javaScriptEnabled: false });
    const page = await context.newPage();
    await page.goto(root + name);
    for (const image of await page.locator("figure.chart img").all()) {
        if (!await image.isVisible()) faults.add(`${name}: without scripts there is no chart`);
    }
    await context.close();
}

async function look(name) {
    const context = await browser.newContext({ viewport: { width: 390, height: 900 }, hasTouch: true });
    const page = await context.newPage();
    page.on("pageerror", (error) => faults.add(`${name}: script: ${error.message}`));
    page.on("request", (request) => request.url().startsWith(root) || request.url().startsWith("data:")
        || faults.add(`${name}: asks for ${request.url()}`));
    await page.goto(root + name);
    await page.evaluate(() => document.fonts.ready);
    await page.waitForFunction(() => document.querySelectorAll("figure.chart:not(.chart-on)").length === 0, null, { timeout: 5000 })
        .catch(() => faults.add(`${name}: a chart stays still`));
    const figures = await page.$$("figure.chart.chart-on");
    for (const width of [390, 1280]) {
        // Charts are drawn again when the window becomes wide.
        await page.setViewportSize({ width, height: 900 });
        for (const figure of figures) {
            const chart = (await figure.getAttribute("id")).replace("fig-", "");
            const fault = (text) => faults.add(`${chart}, ${width} px: ${text}`);
            await check(page, figure, chart, width, fault).catch((error) => fault(error.message));
        }
        await colours(page, (chart) => faults.add(`${chart}, ${width} px: has the same ground on a dark page`));
    }
    if (!inFirefox) await page.emulateMedia({ media: "print" });
    const still = await page.evaluate(() => [...document.querySelectorAll("figure.chart")].every((figure) =>
        figure.querySelector("img").checkVisibility() && !figure.querySelector(".chart-live").checkVisibility()));
    if (!inFirefox && !still) faults.add(`${name}: a chart is not still in print`);
    await context.close();
}

async function check(page, figure, chart, width, fault) {
    if (await figure.evaluate((figure) => figure.querySelector("img").checkVisibility())) fault("the still chart is there as well");
    const told = await byKeys(page, figure, fault);
    if (width === 1280) {
        count.charts += 1;
        count.marks += told.length;
        measured(chart, told, fault);
        await beside(figure, told, fault);
    }
    await byPointer(page, figure, width, fault);
    await switched(page, figure, fault);
    await slid(page, figure, width, fault);
    await shoot(page, figure, `${chart}-${width}`);
}

/// Goes to the second mark by an arrow key, and to all by focus. Returns what each tells.
async function byKeys(page, figure, fault) {
    const address = page.url();
    await figure.evaluate((figure) => figure.querySelector(".point[tabindex='0']").focus());
    for (const key of ["ArrowRight", "ArrowLeft", "ArrowRight"]) await page.keyboard.press(key);
    const [at, all] = await figure.evaluate((figure) => {
        const points = [...figure.querySelectorAll(".point")];
        const at = points.indexOf(document.activeElement);
        return [at, points.map((point) => {
            point.focus({ preventScroll: true });
            const { dataset, ariaLabel } = document.activeElement;
            const method = point.closest("[data-of]").dataset.of;
            return { told: figure.querySelector(".chart-told").textContent, method, kind: dataset.kind, label: ariaLabel ?? "" };
        })];
    });
    if (at !== Math.min(1, all.length - 1)) fault(`the arrow key goes to mark ${at}`);
    if (page.url() !== address) fault("the arrow keys turn the page");
    for (const { told, method, label } of all) {
        if (!told.startsWith(method) || !told.startsWith(label.split(". Drawn by ")[0])) fault(`${method}: told is ${told}`);
    }
    return all;
}

/// What is told has the figures of the chart's table.
function measured(chart, told, fault) {
    const file = join(book, "charts", `${chart}.csv`);
    if (!existsSync(file)) return;
    const [head, ...rows] = readFileSync(file, "utf8").trim().split("\n").map((line) => line.split(","));
    for (const row of rows) {
        const cells = Object.fromEntries(head.map((name, n) => [name, row[n]]));
        const own = told.filter(({ method }) => method.split(", ").includes(row[0]));
        const tells = (kind, figures) => own.filter((one) => !one.kind || one.kind.includes(kind))
            .some(({ told }) => figures.every((figure) => numbers(told).includes(figure)));
        if (cells.error_max && cells.throughput_median) {
            for (const [kind, error] of [["worst case", cells.error_max], ["mean", cells.error_mean]]) {
                const figures = [error, cells.throughput_median].filter((cell) => !["0", "inf"].includes(cell)).map(Number);
                if (!own.length || !tells(kind, figures)) fault(`${row[0]}, ${kind}: ${figures} is not told`);
            }
        } else if (head.length === 3 && own.length) {
            const figures = row.slice(2).filter((cell) => !["0", "inf"].includes(cell)).map(Number);
            if (!tells("", figures)) fault(`${row}: is not told`);
        }
    }
}

/// The figures of the table that follows the chart, where there is one of the same methods, are told as well.
async function beside(figure, told, fault) {
    const table = await figure.evaluate((figure) => {
        let next = figure;
        while ((next = next.nextElementSibling) && !next.matches("figure, h2")) {
            const table = next.querySelector("table");
            if (table) return [...table.rows].map((row) => [...row.cells].map((cell) => cell.textContent.trim()));
        }
        return [];
    });
    const rate = table[0]?.findIndex((name) => /^M\w+\/s$/.test(name)) ?? -1;
    if (rate < 0) return;
    for (const row of table.slice(1)) {
        const own = told.filter(({ method }) => method === row[0]);
        if (own.some(({ kind }) => kind === undefined) && !own.some(({ told }) => told.includes("/s"))) continue;
        count.tables += own.length ? 1 : 0;
        for (const { told } of own) {
            if (!numbers(told).includes(Number(row[rate]))) fault(`${row[0]}: ${row[rate]} stands beside, told is ${told}`);
        }
    }
}

/// The mark that is pointed at is told, or one in the same place: by mouse, in the small window by finger.
async function byPointer(page, figure, width, fault) {
    for (const which of [0, -1]) {
        const [method, x, y] = await figure.evaluate((figure, which) => {
            const point = [...figure.querySelectorAll(".point")].at(which);
            // Into the middle, where no menu covers it; scrollIntoView does not take Firefox to a part of a drawing.
            const { y } = point.getBoundingClientRect();
            scrollBy({ top: y - innerHeight / 2, behavior: "instant" });
            const { left, right, top, bottom } = point.getBoundingClientRect();
            return [point.closest("[data-of]").dataset.of, (left + right) / 2, (top + bottom) / 2];
        }, which);
        // Two marks above each other are scrolled to the same place, and Firefox tells of no move to where the mouse is.
        await page.mouse.move(x, y - 100);
        await (width === 390 && !inFirefox ? page.touchscreen.tap(x, y) : page.mouse.move(x, y));
        const told = await figure.evaluate((figure) => figure.querySelector(".chart-told").textContent);
        if (!told.includes(method)) fault(`${method} is pointed at, told is ${told}`);
    }
}

/// What is switched off is gone, and comes back: the first by a key, all by clicks.
async function switched(page, figure, fault) {
    const pressed = () => figure.evaluate((figure) => {
        const first = figure.querySelector(".chart-switches button");
        first.focus();
        return first.ariaPressed;
    });
    for (const [key, after] of [["Space", "false"], ["Enter", "true"]]) {
        await pressed();
        await page.keyboard.press(key);
        if (await pressed() !== after) fault(`${key} switches nothing`);
    }
    const wrong = await figure.evaluate((figure) => {
        const seen = () => [...figure.querySelectorAll(".point")].filter((point) => point.getClientRects().length).length;
        const all = seen();
        return [...figure.querySelectorAll(".chart-switches button")].filter((button) => {
            button.click();
            const gone = seen() < all && button.ariaPressed === "false";
            button.click();
            return !gone || seen() !== all || button.ariaPressed !== "true";
        }).map((button) => button.textContent);
    });
    if (wrong.length) fault(`cannot be switched off and on: ${wrong}`);
}

/// Each size tells other values, those of its marks; the second one is gone to by a key.
async function slid(page, figure, width, fault) {
    const has = await figure.evaluate((figure) => {
        const range = figure.querySelector("input[type=range]");
        range?.focus();
        return Boolean(range);
    });
    if (!has) return;
    if (width === 1280) count.sliders += 1;
    await page.keyboard.press("ArrowRight");
    const wrong = await figure.evaluate((figure) => {
        const range = figure.querySelector("input[type=range]");
        const found = range.value === "1" ? [] : [`a key moves the slider to ${range.value}`];
        let before = "";
        for (let n = 0; n <= range.max; n++) {
            // The second one as the key left it.
            const value = (n + 1) % (Number(range.max) + 1);
            if (n) {
                range.value = value;
                range.dispatchEvent(new Event("input"));
            }
            const at = range.getAttribute("aria-valuetext");
            const expected = [...figure.querySelectorAll(".point")].filter(({ dataset }) => dataset.at === at)
                .map(({ dataset }) => dataset.value).join();
            const told = [...figure.querySelectorAll(".chart-values strong")].map(({ textContent }) => textContent).join();
            if (told !== expected || !told) found.push(`the slider tells ${told}`);
            const now = figure.querySelector(".chart-sizes").textContent;
            if (now === before) found.push("the slider changes nothing");
            before = now;
        }
        return found;
    });
    wrong.forEach(fault);
}

/// Charts follow the page's theme.
async function colours(page, fault) {
    const same = await page.evaluate(() => {
        const { classList } = document.documentElement;
        const cards = [...document.querySelectorAll("figure.chart-on svg .card")];
        const grounds = () => cards.map((card) => getComputedStyle(card).fill);
        const light = grounds();
        classList.replace("light", "navy");
        const dark = grounds();
        classList.replace("navy", "light");
        return cards.filter((_, n) => light[n] === dark[n]).map((card) => card.closest("figure").id.replace("fig-", ""));
    });
    same.forEach(fault);
}

/// The numbers in a text; 8·10⁻⁴ is one.
function numbers(text) {
    const digits = "⁰¹²³⁴⁵⁶⁷⁸⁹";
    const plain = text.replace(/·10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)/g, (_, power) =>
        `e${[...power].map((sign) => sign === "⁻" ? "-" : digits.indexOf(sign)).join("")}`);
    return (plain.match(/\d+(\.\d+)?(e-?\d+)?/g) ?? []).map(Number);
}

/// A picture in either theme: a mark told, the first method off.
async function shoot(page, figure, name) {
    if (!pictures) return;
    const first = () => figure.evaluate((figure) => {
        const buttons = figure.querySelectorAll(".chart-switches button");
        if (buttons.length > 1) buttons[0].click();
        figure.querySelector(".point[tabindex='0']").focus();
    });
    await first();
    for (const theme of ["light", "navy"]) {
        await page.evaluate((theme) => document.documentElement.classList.replace(theme === "navy" ? "light" : "navy", theme), theme);
        await figure.screenshot({ path: join(pictures, `${name}-${theme}.png`) });
    }
    await page.evaluate(() => document.documentElement.classList.replace("navy", "light"));
    await first();
}
