<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Database;

use Msisf\Scripts\Database\ImportRecord;
use Msisf\Scripts\Database\ImportState;
use PHPUnit\Framework\TestCase;

final class ImportRecordTest extends TestCase
{
    /** @dataProvider places */
    public function testOverlapsOnlyIfASampleIsShared(array $place, bool $expected): void
    {
        $record = self::record(100, 20, 40, 10);
        $other = self::record(...$place);

        self::assertSame([$expected, $expected], [$record->overlaps($other), $other->overlaps($record)]);
    }

    /** First row, rows, first column, columns. */
    public static function places(): array
    {
        return [
            'the same' => [[100, 20, 40, 10], true],
            'inside' => [[105, 1, 45, 1], true],
            'last row and column' => [[119, 5, 49, 5], true],
            'below' => [[120, 5, 40, 10], false],
            'above' => [[95, 5, 40, 10], false],
            'east of it' => [[100, 20, 50, 10], false],
            'west of it' => [[100, 20, 30, 10], false],
            'across' => [[0, 720, 44, 2], true],
            'rows of it elsewhere' => [[100, 20, 300, 10], false],
        ];
    }

    public function testSamplesDoneIsWholeRows(): void
    {
        self::assertSame(70, self::record(100, 20, 40, 10)->samplesDone());
    }

    /** @dataProvider files */
    public function testIsOfSameFilesNeedsLabelImageAndFormat(string $label, string $image, int $format, bool $expected): void
    {
        self::assertSame($expected, self::record(0, 1, 0, 1)->isOfSameFiles(self::record(5, 6, 7, 8, $label, $image, $format)));
    }

    public static function files(): array
    {
        return [['l', 'i', 1, true], ['L', 'i', 1, false], ['l', 'I', 1, false], ['l', 'i', 2, false]];
    }

    private static function record(
        int $row,
        int $rows,
        int $column,
        int $columns,
        string $label = 'l',
        string $image = 'i',
        int $format = 1,
    ): ImportRecord {
        return new ImportRecord('ldem_4', 'P', ImportState::Importing, $format, $label, $image, 800, $row, $rows, $column, $columns, 7);
    }
}
