// The browser that the tests look with, of Debian: Chromium, or Firefox where BROWSER is firefox.

import { chromium, firefox } from "playwright-core";

/// Firefox is spoken to by WebDriver BiDi: playwright's own way needs a Firefox that playwright has changed. By it scripts are not
/// switched off, print is not emulated, requests for files are not told and there are no fingers; playwright-core 1.65 asks for
/// what Firefox 153 does not know yet.
export const inFirefox = process.env.BROWSER === "firefox";

/// CHROMIUM and FIREFOX name the programs where they are not in /usr/bin.
export function launch() {
    if (inFirefox) return firefox.launch({ channel: "moz-firefox", executablePath: process.env.FIREFOX ?? "/usr/bin/firefox-esr" });
    return chromium.launch({
        executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
        // Debian's Chromium asks Google's servers for things unless told not to.
        args: ["--no-sandbox", "--disable-gpu", "--disable-background-networking", "--disable-component-update",
            "--disable-sync", "--disable-quic", "--no-first-run"],
    });
}
