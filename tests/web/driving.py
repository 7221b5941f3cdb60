"""The page driven as a person would: asked, looked at, waited for."""

from __future__ import annotations

VIEWS = ("steps", "cook", "tree", "when", "why", "compare")
PLANNED = "return !!document.querySelector('#result .tabs') && result.getAttribute('aria-busy') === 'false'"
ENTER, TAB, DOWN, LEFT, RIGHT, CONTROL = "\ue007", "\ue004", "\ue015", "\ue012", "\ue014", "\ue009"


def open_page(browser, address):
    browser.get(f"{address}/")
    until(browser, "return document.querySelectorAll('#dish option').length > 1")


def until(browser, script):
    from selenium.webdriver.support.ui import WebDriverWait

    return WebDriverWait(browser, 120, poll_frequency=0.05).until(lambda driver: driver.execute_script(script))


def focused(browser):
    return browser.switch_to.active_element


def text_of(browser, selector):
    return browser.execute_script("return document.querySelector(arguments[0]).innerText", selector)


def view(browser, name):
    """Show a view of the plan that is there."""
    browser.find_element("css selector", f".tabs a[href*='view={name}']").send_keys(ENTER)
    until(browser, f"return document.body.dataset.view === '{name}'")


def asked(browser):
    """Wait for the answer to what was asked."""
    until(browser, "return result.getAttribute('aria-busy') === 'false' && document.activeElement === result")


def plan(browser, *foods):
    box = browser.find_element("id", "ingredient")
    browser.execute_script("dish.value = 'salad'")
    for food in foods:
        box.send_keys(food, ENTER)
    box.send_keys(CONTROL + ENTER)
    asked(browser)


def complaints(browser):
    return [entry["message"] for entry in browser.get_log("browser") if entry["level"] in {"SEVERE", "WARNING"}]


def chips(browser, name):
    return browser.execute_script("return [...window[arguments[0]].children].map(li => li.firstChild.data)", name)
