// Menus: a button with a sheet of choices, and actions as its rows.

import type { ComponentChildren } from 'preact';
import { act, actionOf, whyNotTo } from './actions';

/** A button with a sheet of choices below it: the platform's own popover, which closes itself. */
export function Menu({ id, label, title, children }: { id: string; label: ComponentChildren; title: string; children: ComponentChildren }) {
    const place = (button: HTMLElement) => {
        const menu = document.getElementById(id);
        const box = button.getBoundingClientRect();
        menu?.style.setProperty('left', `${Math.max(8, Math.min(box.left, innerWidth - 296))}px`);
        menu?.style.setProperty('top', `${box.bottom + 4}px`);
    };
    const attributes = { popovertarget: id } as Record<string, string>;
    return (
        <>
            <button {...attributes} title={title} aria-label={title} aria-haspopup="true" onPointerDown={(e) => place(e.currentTarget)} onFocus={(e) => place(e.currentTarget)}>
                {label}
            </button>
            <div id={id} popover="auto" class="menu">{children}</div>
        </>
    );
}

/** An action as a row of a menu. */
export function Item({ id, label }: { id: string; label?: string }) {
    const why = whyNotTo(id);
    const action = actionOf(id);
    return (
        <button
            class="item"
            aria-disabled={why !== null}
            title={why ?? undefined}
            onClick={(e) => {
                (e.currentTarget.closest('[popover]') as HTMLElement | null)?.hidePopover();
                act(id);
            }}
        >
            <span>{label ?? action?.label}</span>
            <kbd>{action?.keys}</kbd>
        </button>
    );
}
