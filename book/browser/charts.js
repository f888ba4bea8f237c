// Asks every chart of the built book, in headless Chromium, from files.
//
//     npm ci && node charts.js [FOLDER] [PICTURES]     FOLDER: the book, by default target/book
//
// It fails where a chart does not answer: where a mark, reached by keys or pointed at, tells other numbers than the measured table
// or the table beside it; where a method that is switched off stays or does not come back; where the slider tells nothing else;
// where a chart is missing in print or without scripts, or a request leaves the book. Pictures of all charts, one method off and
// a mark told, are written to PICTURES, if there is such a folder. CHROMIUM names the browser where it is not /usr/bin/chromium.

import { existsSync, readFileSync, readdirSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

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
const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-gpu", "--disable-background-networking", "--disable-component-update",
        "--disable-sync", "--disable-quic", "--no-first-run"],
});
for (const name of pages) {
    await withoutScript(name);
    for (const width of [1280, 390]) await look(name, width);
}
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

async function look(name, width) {
    const context = await browser.newContext({ viewport: { width, height: 900 }, hasTouch: width === 390 });
    const page = await context.newPage();
    page.on("pageerror", (error) => faults.add(`${name}: script: ${error.message}`));
    page.on("request", (request) => request.url().startsWith(root) || request.url().startsWith("data:")
        || faults.add(`${name}: asks for ${request.url()}`));
    await page.goto(root + name);
    await page.evaluate(() => document.fonts.ready);
    for (const figure of await page.locator("figure.chart").all()) {
        const chart = (await figure.getAttribute("id")).replace("fig-", "");
        const fault = (text) => faults.add(`${chart}, ${width} px: ${text}`);
        await check(page, figure, chart, width, fault).catch((error) => fault(error.message));
    }
    await page.emulateMedia({ media: "print" });
    for (const figure of await page.locator("figure.chart").all()) {
        const still = await figure.locator("img").isVisible() && !await figure.locator(".chart-live").isVisible();
        if (!still) faults.add(`${name}: a chart is not still in print`);
    }
    await context.close();
}

async function check(page, figure, chart, width, fault) {
    await figure.locator(".chart-live").waitFor({ timeout: 5000 });
    await figure.scrollIntoViewIfNeeded();
    if (await figure.locator("img").isVisible()) fault("the still chart is there as well");
    const told = await byKeys(page, figure, fault);
    if (width === 1280) {
        count.charts += 1;
        count.marks += told.length;
        measured(chart, told, fault);
        await beside(figure, told, fault);
    }
    await byPointer(page, figure, width, fault);
    await switched(figure, fault);
    await slid(page, figure, fault);
    await colours(page, figure, fault);
    await shoot(page, figure, `${chart}-${width}`);
}

/// Goes to the second mark by an arrow key, and to all by focus. Returns what each tells.
async function byKeys(page, figure, fault) {
    const address = page.url();
    await figure.locator(".point[tabindex='0']").focus();
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("ArrowLeft");
    await page.keyboard.press("ArrowRight");
    const at = await figure.evaluate((figure) => [...figure.querySelectorAll(".point")].indexOf(document.activeElement));
    if (at !== Math.min(1, await figure.locator(".point").count() - 1)) fault(`the arrow key goes to mark ${at}`);
    if (page.url() !== address) fault("the arrow keys turn the page");
    const all = await figure.evaluate((figure) => [...figure.querySelectorAll(".point")].map((point) => {
        point.focus();
        const { dataset, ariaLabel } = document.activeElement;
        const method = point.closest("[data-of]").dataset.of;
        return { told: figure.querySelector(".chart-told").textContent, method, kind: dataset.kind, label: ariaLabel ?? "" };
    }));
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

/// The mark that is pointed at is told, or one in the same place.
async function byPointer(page, figure, width, fault) {
    for (const point of [figure.locator(".point").first(), figure.locator(".point").last()]) {
        // In the middle, where no menu covers it.
        await point.evaluate((point) => point.scrollIntoView({ block: "center", behavior: "instant" }));
        const { x, y, width: wide, height } = await point.boundingBox();
        if (width === 390) await page.touchscreen.tap(x + wide / 2, y + height / 2);
        else await page.mouse.move(x + wide / 2, y + height / 2);
        const method = await point.evaluate((point) => point.closest("[data-of]").dataset.of);
        const told = await figure.locator(".chart-told").textContent();
        if (!told.includes(method)) fault(`${method} is pointed at, told is ${told}`);
    }
}

/// What is switched off is gone, and comes back: the first by keys, all by clicks.
async function switched(figure, fault) {
    const first = figure.locator(".chart-switches button").first();
    await first.press("Space");
    if (await first.getAttribute("aria-pressed") !== "false") fault("a key switches nothing off");
    await first.press("Enter");
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

/// Each size tells other values, those of its marks.
async function slid(page, figure, fault) {
    const range = figure.locator("input[type=range]");
    if (!await range.count()) return;
    count.sliders += 1;
    const values = () => figure.locator(".chart-sizes").evaluate((part) => part.textContent);
    const expected = () => figure.evaluate((figure) => {
        const at = figure.querySelector("input").getAttribute("aria-valuetext");
        return [...figure.querySelectorAll(".point")].filter(({ dataset }) => dataset.at === at).map(({ dataset }) => dataset.value);
    });
    await range.focus();
    let before = await values();
    for (let n = Number(await range.getAttribute("max")); n > 0; n--) {
        await page.keyboard.press("ArrowRight");
        const now = await values();
        if (now === before) fault("the slider changes nothing");
        const found = await figure.locator(".chart-values strong").allTextContents();
        if (found.join() !== (await expected()).join() || !found.length) fault(`the slider tells ${found}`);
        before = now;
    }
    await page.keyboard.press("Home");
}

/// A chart follows the page's theme.
async function colours(page, figure, fault) {
    const [light, dark] = await figure.evaluate((figure) => ["light", "navy"].map((theme) => {
        document.documentElement.classList.remove("light", "navy");
        document.documentElement.classList.add(theme);
        return getComputedStyle(figure.querySelector("svg .card")).fill;
    }));
    await page.evaluate(() => document.documentElement.classList.replace("navy", "light"));
    if (light === dark) fault("has the same ground on a dark page");
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
    const button = figure.locator(".chart-switches button").first();
    const [several] = [await figure.locator(".chart-switches button").count() > 1];
    if (several) await button.click();
    await figure.locator(".point[tabindex='0']").focus();
    for (const theme of ["light", "navy"]) {
        await page.evaluate((theme) => document.documentElement.classList.replace(theme === "navy" ? "light" : "navy", theme), theme);
        await figure.screenshot({ path: join(pictures, `${name}-${theme}.png`) });
    }
    await page.evaluate(() => document.documentElement.classList.replace("navy", "light"));
    if (several) await button.click();
}
