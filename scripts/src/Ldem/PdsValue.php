<?php

declare(strict_types=1);

namespace Msisf\Scripts\Ldem;

/** A value of a PDS3 label: one text, or a sequence or set of values. */
final class PdsValue
{
    /**
     * @param string $text without quotes; '' for a sequence or set
     * @param bool $isQuoted the text stood in quotes, so it is no number
     * @param string|null $unit as written, e.g. "pix/deg"
     * @param list<PdsValue>|null $items the values of a sequence or set; null for one text
     * @param int $line line of the label, from 1
     */
    public function __construct(
        public readonly string $text,
        public readonly bool $isQuoted,
        public readonly ?string $unit,
        public readonly ?array $items,
        public readonly int $line,
    ) {
    }

    /**
     * The text as a word of the standard: capitals, with one underscore for blanks, hyphens and underscores. "Band Sequential" is
     * BAND_SEQUENTIAL.
     */
    public function word(): string
    {
        return self::wordOf($this->text);
    }

    /** A text as word() has it. */
    public static function wordOf(string $text): string
    {
        return trim(preg_replace('/[\s_-]+/', '_', strtoupper($text)), '_');
    }

    /** As the label writes it, on one line. */
    public function __toString(): string
    {
        if ($this->items !== null) {
            return '(' . implode(', ', $this->items) . ')';
        }

        return preg_replace('/\s+/', ' ', trim($this->text)) . ($this->unit === null ? '' : " <$this->unit>");
    }
}
