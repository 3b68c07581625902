<?php

declare(strict_types=1);

namespace Msisf\Scripts\Ldem;

use Msisf\Scripts\Exception\BadInputException;

/** Where a label's ^IMAGE says that the samples are. */
final class LdemImagePointer
{
    private const KEYWORD = '^IMAGE';

    /**
     * @param string|null $fileName name of the image's file beside the label; null for an attached label
     * @param int $offset bytes of that file before the first sample
     */
    private function __construct(public readonly ?string $fileName, public readonly int $offset)
    {
    }

    /**
     * Reads ^IMAGE = "FILE", ("FILE", record), ("FILE", byte <BYTES>), record, or byte <BYTES>; both count from 1.
     *
     * @param int|null $recordBytes RECORD_BYTES; null if the label has none
     * @throws BadInputException ^IMAGE is missing or of another form
     */
    public static function read(PdsObject $holder, ?int $recordBytes): self
    {
        $pointer = $holder->required(self::KEYWORD);
        $items = $pointer->items;
        if ($items === null) {
            return $pointer->isQuoted
                ? new self(self::plainName($holder, $pointer), 0)
                : new self(null, self::offsetOf($holder, $pointer, $recordBytes));
        }
        if (!in_array(count($items), [1, 2], true) || !$items[0]->isQuoted) {
            throw $holder->unfit(self::KEYWORD, $pointer, 'a file name, a place, or both are needed');
        }
        $offset = isset($items[1]) ? self::offsetOf($holder, $items[1], $recordBytes) : 0;

        return new self(self::plainName($holder, $items[0]), $offset);
    }

    private static function plainName(PdsObject $holder, PdsValue $file): string
    {
        if ($file->text === '' || strpbrk($file->text, "/\\:\0") !== false) {
            throw $holder->unfit(self::KEYWORD, $file, 'the plain name of a file beside the label is needed');
        }

        return $file->text;
    }

    private static function offsetOf(PdsObject $holder, PdsValue $place, ?int $recordBytes): int
    {
        $number = !$place->isQuoted && preg_match('/^[0-9]{1,10}$/D', $place->text) === 1 ? (int) $place->text : 0;
        if ($number < 1) {
            throw $holder->unfit(self::KEYWORD, $place, 'a record or byte number from 1 is needed');
        }
        if ($place->unit === null) {
            $bytes = $recordBytes ?? throw $holder->unfit(self::KEYWORD, $place, 'the label has no RECORD_BYTES to count records with');

            return ($number - 1) * $bytes;
        }
        if (strcasecmp($place->unit, 'BYTES') !== 0) {
            throw $holder->unfit(self::KEYWORD, $place, 'the unit <BYTES> or none is needed');
        }

        return $number - 1;
    }
}
