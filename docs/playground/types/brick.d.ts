// What the page takes from ev3proto/brick/servers/page/static/brick.js.
export function make<K extends keyof HTMLElementTagNameMap>(tag: K, text?: string, className?: string): HTMLElementTagNameMap[K];
export function saveAs(name: string, blob: Blob): void;
export function showBrick(front: HTMLElement, more: HTMLElement, send: (action: object) => void): { take: (message: object) => void, silence: () => void };
