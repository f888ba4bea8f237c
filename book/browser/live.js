// Moves every figure of the built book that moves, in headless Chromium, or in Firefox with BROWSER=firefox, from files.
//
//     npm ci && node live.js [FOLDER] [PICTURES]     FOLDER: the book, by default target/book
//
// It fails where a figure is not found, does not change when it is dragged by mouse or finger or moved by the keys, or does not
// return when it is moved back; where the page scrolls when a finger drags, or does not when one goes over it; where a figure tells
// other numbers than book/live/states.json, which a Rust test holds the same functions against, is missing in print or without
// scripts, where methods cannot be timed, or where a request leaves the book. Pictures of all figures, before and after, are
// written to PICTURES, if there is such a folder. launch.js says which browser it is, and what Firefox cannot be asked.

import { existsSync, readFileSync, readdirSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { inFirefox, launch } from "./launch.js";

const here = dirname(fileURLToPath(import.meta.url));
const book = resolve(process.argv[2] ?? join(here, "../../target/book"));
const pictures = process.argv[3];
const code = join(book, "live-code.js");
const script = existsSync(code) ? readFileSync(code, "utf8") : "";
if (!script.startsWith("liveFigures(")) {
    console.error(`${code}: the figures of this book do not move; cargo run -p book says why`);
    process.exit(1);
}
const root = pathToFileURL(book).href + "/";
const { figures } = JSON.parse(script.slice(script.indexOf("(") + 1, script.lastIndexOf(")")));
const states = JSON.parse(readFileSync(join(here, "../live/states.json"), "utf8"));
/// Of these pages alone, as 01: PAGE=01 node live.js
const only = process.env.PAGE ?? "";
const pages = readdirSync(book).filter((name) => name.startsWith(only) && name.endsWith(".html") && name !== "print.html");

/// A change should take less than 16 ms. What is measured hangs on the machine, so that only ten times as much is a fault.
const slowest = 160;

/// What is taken hold of, for each kind of input that is dragged.
const grips = { point: ".live-handle", turn: ".live-picture", slider: "input[type=range]" };

const faults = [];
const times = [];
let stated = 0;
const browser = await launch();
const missing = new Set(figures);
for (const page of pages) {
    const text = readFileSync(join(book, page), "utf8");
    const its = [...missing].filter(({ name }) => text.includes(`data-live="${name}"`));
    its.forEach((figure) => missing.delete(figure));
    if (its.length) await check(its, root + page).catch((error) => faults.push(`${page}: ${error.message}`));
}
if (!only) for (const { name } of missing) faults.push(`${name}: no page has it`);
await browser.close();

for (const fault of faults) console.error(fault);
console.log(`${times.length} figures that move, ${stated} states: ${faults.length} faults`);
for (const [name, median, dragged, choice] of times) {
    const slowest = choice && `; dragged, with ${choice}, the slowest: ${dragged.toFixed(1)} ms`;
    console.log(`${name}: ${median.toFixed(1)} ms a change (median)${slowest}`);
}
process.exit(faults.length ? 1 : 0);

/// The figures of a page, in two widths.
async function check(its, address) {
    if (!inFirefox) await withoutScript(its, address);
    for (const width of [1280, 390]) {
        const context = await browser.newContext({ viewport: { width, height: 900 }, hasTouch: width === 390 && !inFirefox });
        const page = await context.newPage();
        const fault = (text) => faults.push(`${address}: ${text}`);
        page.on("pageerror", (error) => fault(`script: ${error.message}`));
        page.on("request", (request) => request.url().startsWith(root) || request.url().startsWith("data:")
            || fault(`asks for ${request.url()}`));
        await page.goto(address);
        for (const figure of its) {
            await moved(figure, page, width).catch((error) => faults.push(`${figure.name}: ${error.message}`));
        }
        await context.close();
    }
}

/// A figure: moved in each way, it changes and returns; in the large window it is also set to each state and measured.
async function moved(figure, page, width) {
    const fault = (text) => faults.push(`${figure.name}: ${text}`);
    const part = page.locator(`figure[data-live="${figure.name}"]`);
    await part.locator(".live").waitFor({ timeout: 10_000 });
    await part.scrollIntoViewIfNeeded();
    if (await part.locator(":scope > img").isVisible() !== figure.stays) {
        fault(`the still figure ${figure.stays ? "is gone" : "is there as well"}`);
    }
    await shoot(part, page, `${figure.name}-${width}`);
    await dragged(figure, page, part, byMouse(page), fault);
    if (width === 390 && !inFirefox) {
        const finger = await byFinger(page);
        await dragged(figure, page, part, finger, fault);
        await scrolled(page, part, finger, fault);
    }
    if (pictures) {
        const [from, to] = await way(part.locator(grips[figure.inputs[0].kind]).first());
        const hand = byMouse(page);
        await hand.take(...from);
        await hand.drag(from, to);
        await hand.leave();
        await shoot(part, page, `${figure.name}-${width}-dragged`);
        await part.locator(".live-controls button").click();
    }
    await keyed(page, part, fault);
    if (width !== 1280) return;
    for (const state of states.filter((state) => state.figure === figure.name)) {
        await page.evaluate(set, { figure, values: state.values });
        await drawn(page);
        const told = await part.locator(".live-told").textContent();
        stated += 1;
        if (told !== state.told) fault(`${state.values} tells\n  ${told}\nnot\n  ${state.told}`);
    }
    await measure(figure, page, fault);
    if (figure.inputs.some(({ kind }) => kind === "times")) await timed(figure, page, part, fault);
    if (inFirefox) return;
    await page.emulateMedia({ media: "print" });
    if (!await part.locator(":scope > img").isVisible()) fault("is missing in print");
    await page.emulateMedia({ media: "screen" });
}

/// Without scripts the still figures are there.
async function withoutScript(its, address) {
    const context = await browser.newContext({ javaScriptEnabled: false });
    const page = await context.newPage();
    await page.goto(address);
    for (const { name } of its) {
        const image = page.locator(`figure[data-live="${name}"] > img`);
        if (!await image.isVisible()) faults.push(`${name}: without scripts there is nothing`);
    }
    await context.close();
}

/// Drags one input of each kind, there and back.
async function dragged(figure, page, part, hand, fault) {
    for (const kind of new Set(figure.inputs.map(({ kind }) => kind))) {
        if (!grips[kind]) continue;
        const [from, to] = await way(part.locator(grips[kind]).first());
        const scrolled = await page.evaluate(() => scrollY);
        await hand.take(...from);
        await drawn(page);
        // A slider may have moved already: a browser's thumb is as wide as it likes.
        const first = await shown(part);
        await hand.drag(from, to);
        await drawn(page);
        if (await shown(part) === first) fault(`${kind}: does not change when it is dragged by ${hand.name}`);
        await hand.drag(to, from);
        await hand.leave();
        await drawn(page);
        if (await shown(part) !== first) fault(`${kind}: does not return when it is dragged back by ${hand.name}`);
        if (await page.evaluate(() => scrollY) !== scrolled) fault(`${kind}: the page scrolls when it is dragged by ${hand.name}`);
        await part.locator(".live-controls button").evaluate((button) => button.click());
        await drawn(page);
    }
}

/// From where to where in the window a grip is dragged.
async function way(grip) {
    // In the middle, where no menu covers it.
    await grip.evaluate((grip) => grip.scrollIntoView({ block: "center", behavior: "instant" }));
    const { x, y, width, height } = await grip.boundingBox();
    // A slider is taken where its thumb is, which is 16 px wide.
    const share = await grip.evaluate(({ value, min, max }) => max ? (value - min) / (max - min) : 1 / 2);
    const [left, top] = [x + 8 + share * (width - 16), y + height / 2];
    const back = share > 1 / 2 || left + 80 > await grip.evaluate(() => innerWidth);
    return [[left, top], [left + (back ? -70 : 70), top - 45]];
}

/// The mouse as a hand that drags.
function byMouse({ mouse }) {
    return {
        name: "mouse",
        take: async (x, y) => {
            await mouse.move(x, y);
            await mouse.down();
        },
        drag: (_, [x, y]) => mouse.move(x, y, { steps: 5 }),
        leave: () => mouse.up(),
    };
}

/// A finger, which Chromium takes for a true one: it scrolls the page where nothing else takes it.
async function byFinger(page) {
    const client = await page.context().newCDPSession(page);
    const touch = (type, ...touchPoints) => client.send("Input.dispatchTouchEvent", { type, touchPoints });
    return {
        name: "finger",
        take: (x, y) => touch("touchStart", { x, y }),
        drag: async (from, to) => {
            const steps = 10;
            for (let n = 1; n <= steps; n++) {
                const [x, y] = [0, 1].map((axis) => from[axis] + (to[axis] - from[axis]) * n / steps);
                await touch("touchMove", { x, y });
            }
        },
        leave: () => touch("touchEnd"),
    };
}

/// A finger that goes up over words, or over a picture that is turned to the sides, scrolls the page, and changes nothing.
async function scrolled(page, part, finger, fault) {
    const first = await shown(part);
    for (const selector of [".live-hint", ".live-turned"]) {
        const place = part.locator(selector);
        if (!await place.count()) continue;
        const [from] = await way(place);
        const before = await page.evaluate(() => scrollY);
        await finger.take(...from);
        await finger.drag(from, [from[0], from[1] - 150]);
        await finger.leave();
        await page.waitForFunction((before) => scrollY > before + 50, before, { timeout: 2000 })
            .catch(() => fault(`${selector}: a finger does not scroll the page`));
        await drawn(page);
        if (await shown(part) !== first) fault(`${selector}: changes when a finger scrolls the page`);
    }
}

/// By keys: each handle, slider and choice that can be reached, there and back.
async function keyed(page, part, fault) {
    for (const control of await part.locator(".live :is(.live-handle, input, select)").all()) {
        const before = await shown(part);
        const name = await control.evaluate((control) => control.ariaLabel ?? control.parentElement.textContent);
        await control.focus();
        // What is at its upper end, or shows no more there, goes down.
        let changed = false;
        for (const keys of [["ArrowUp", "ArrowDown"], ["ArrowDown", "ArrowUp"]]) {
            if (changed) break;
            const value = await control.evaluate((control) => control.value);
            await page.keyboard.press(keys[0]);
            await drawn(page);
            changed = await shown(part) !== before;
            const moved = changed || await control.evaluate((control) => control.value) !== value;
            if (moved) await page.keyboard.press(keys[1]);
            await drawn(page);
            if (await shown(part) !== before) fault(`${name}: does not return by keys`);
        }
        if (!changed) fault(`${name}: does not change by keys`);
        const address = page.url();
        await page.keyboard.press("ArrowRight");
        await page.keyboard.press("ArrowLeft");
        await drawn(page);
        if (page.url() !== address) fault(`${name}: the arrow keys turn the page`);
    }
}

/// What is seen and what is told.
function shown(part) {
    return part.evaluate((figure) => {
        const canvas = figure.querySelector("canvas");
        const drawing = canvas ? canvas.toDataURL() : figure.querySelector(".live-drawing").innerHTML;
        return drawing + figure.querySelector(".live-told").textContent;
    });
}

/// Waits until what was asked for is drawn, in all its pixels.
async function drawn(page) {
    await page.evaluate(() => new Promise((done) => { requestAnimationFrame(() => requestAnimationFrame(done)); }));
    await page.locator(".live[data-coarse]").waitFor({ state: "detached" });
}

/// Runs in the page: sets the inputs of a figure, points by the arrow keys.
function set({ figure, values }) {
    const panel = document.querySelector(`figure[data-live="${figure.name}"] .live`);
    const [handles, ranges, selects] = [".live-handle", "input[type=range]", "select"]
        .map((selector) => [...panel.querySelectorAll(selector)]);
    const rest = [...values];
    const slide = (range) => {
        range.value = rest.shift();
        range.dispatchEvent(new Event("input"));
    };
    panel.querySelector("button:not(.live-handle)").click();
    for (const { kind, from, step } of figure.inputs) {
        if (kind === "point") {
            const handle = handles.shift();
            for (const [axis, keys] of [["ArrowLeft", "ArrowRight"], ["ArrowDown", "ArrowUp"]].entries()) {
                const steps = Math.round((rest.shift() - from[axis]) / step);
                const event = () => new KeyboardEvent("keydown", { key: keys[steps > 0 ? 1 : 0] });
                for (let n = 0; n < Math.abs(steps); n++) handle.dispatchEvent(event());
            }
        } else if (kind === "choice") {
            const select = selects.shift();
            select.selectedIndex = rest.shift();
            select.dispatchEvent(new Event("change"));
        } else {
            for (let n = 0; n < from.length; n++) slide(ranges.shift());
        }
    }
}

/// Times all methods: a row each, whatever the times, until the picture is turned, which may be before they are there.
async function timed(figure, page, part, fault) {
    const rows = part.locator(".live-times + .live-table tr");
    const slider = part.locator("input[type=range]").first();
    const time = async (meanwhile = () => {}) => {
        await part.locator(".live-times button").click();
        await meanwhile();
        await part.locator(".live-times button:not([aria-disabled=true])").waitFor({ timeout: 60_000 });
    };
    await part.locator(".live-controls button").click();
    await drawn(page);
    const before = await shown(part);
    await time();
    const cells = await rows.evaluateAll((rows) => rows.slice(1).map((row) => [...row.cells].map(({ textContent }) => textContent)));
    const names = figure.inputs.find(({ kind }) => kind === "choice").rows.map(({ name }) => name);
    if (String(cells.map(([name]) => name)) !== String(names)) fault(`times ${cells.map(([name]) => name)}, not ${names}`);
    for (const [name, ...numbers] of cells) {
        if (!numbers.every((number) => number > 0)) fault(`${name}: takes ${numbers}`);
    }
    if (await shown(part) !== before) fault("is another picture once all methods are timed");
    await part.locator("select").last().press("ArrowUp");
    await drawn(page);
    if (await rows.count() === 0) fault("choosing a method forgets the times");
    await time(() => slider.press("ArrowUp"));
    if (await rows.count() > 0) fault("shows the times of the picture before it was turned");
    await time();
    if (await rows.count() === 0) fault("times methods no second time");
    await slider.press("ArrowUp");
    await drawn(page);
    if (await rows.count() > 0) fault("shows the times of another picture");
}

/// How long a change takes, from the values to the page: the median of all so far, and the longest median of those choices with
/// which a slider is dragged.
async function measure(figure, page, fault) {
    const all = await page.evaluate((name) => performance.getEntriesByName("live")
        .filter(({ detail }) => detail === name).map(({ duration }) => duration).sort((a, b) => a - b), figure.name);
    const median = all[Math.floor(all.length / 2)];
    const [dragged, choice] = await page.evaluate(slowestDrag, figure.name);
    times.push([figure.name, median, dragged, choice]);
    for (const time of [median, dragged]) if (!(time < slowest)) fault(`a change takes ${time} ms`);
}

/// Runs in the page: drags a slider with each choice of a figure. Returns the longest median, and with which.
async function slowestDrag(name) {
    const panel = document.querySelector(`figure[data-live="${name}"] .live`);
    const range = panel.querySelector("input[type=range]");
    const frame = () => new Promise((done) => { requestAnimationFrame(() => setTimeout(done)); });
    const all = [[0, ""]];
    for (const select of range ? panel.querySelectorAll("select") : []) {
        for (const [row, { textContent }] of [...select.options].entries()) {
            panel.querySelector(".live-controls button").click();
            select.selectedIndex = row;
            select.dispatchEvent(new Event("change"));
            await frame();
            performance.clearMeasures("live");
            for (let n = 0; n < 9; n++) {
                range.stepUp(3);
                range.dispatchEvent(new Event("input"));
                await frame();
            }
            const times = performance.getEntriesByName("live").map(({ duration }) => duration).sort((a, b) => a - b);
            all.push([times[Math.floor(times.length / 2)], textContent]);
        }
    }
    return all.sort(([a], [b]) => b - a)[0];
}

/// A picture in either theme.
async function shoot(part, page, name) {
    if (!pictures) return;
    for (const theme of ["light", "navy"]) {
        await page.evaluate((theme) => document.documentElement.classList.replace(theme === "navy" ? "light" : "navy", theme), theme);
        await part.screenshot({ path: join(pictures, `${name}-${theme}.png`) });
    }
    await page.evaluate(() => document.documentElement.classList.replace("navy", "light"));
}
