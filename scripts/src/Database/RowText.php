<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

use Generator;
use Msisf\Scripts\Ldem\LdemImage;

/** Writes bands of lines as the rows that a RadiusLoader takes. */
final class RowText
{
    /** At least so many rows are passed on at once: 1 MB of text, 3 MB in PHP. */
    private const CHUNK_ROWS = 20000;

    /** @var array<int, string> "TAB radius" by sample value: integer products have few values, and writing a double is slow */
    private array $radii = [];

    public function __construct(private readonly LdemImage $image)
    {
    }

    /**
     * Column by column: neighbours on the Moon then follow each other, and the spatial index fills in a quarter less time than
     * line by line (docs/database.md).
     *
     * @param array<int, list<int|float>> $band sample values by the product's line
     * @return Generator<list<string>> "row TAB column TAB radius", rows and columns of the whole Moon
     */
    public function chunks(array $band): Generator
    {
        $texts = [];
        foreach ($band as $line => $values) {
            $texts[$this->image->label->firstLine() + $line . "\t"] = $this->image->label->sampleType->isInteger()
                ? $this->integerRadii($values)
                : array_map(fn (float $value): string => "\t" . $this->image->radius($value), $values);
        }
        $rows = [];
        $firstSample = $this->image->label->firstSample();
        for ($sample = 0; $sample < $this->image->label->lineSamples; $sample++) {
            $column = $firstSample + $sample;
            foreach ($texts as $row => $radii) {
                $rows[] = $row . $column . $radii[$sample];
            }
            if (count($rows) >= self::CHUNK_ROWS) {
                yield $rows;
                $rows = [];
            }
        }
        if ($rows !== []) {
            yield $rows;
        }
    }

    /**
     * @param list<int> $values
     * @return list<string>
     */
    private function integerRadii(array $values): array
    {
        $texts = [];
        foreach ($values as $value) {
            $texts[] = $this->radii[$value] ??= "\t" . $this->image->radius($value);
        }

        return $texts;
    }
}
