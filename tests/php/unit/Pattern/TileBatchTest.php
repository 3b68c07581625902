<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Pattern;

use Msisf\Scripts\Pattern\TileBatch;
use Msisf\Scripts\Pattern\TileId;
use Msisf\Scripts\Pattern\TileMeshLayout;
use Msisf\Tests\Support\FormulaRadiusSource;
use PHPUnit\Framework\TestCase;

final class TileBatchTest extends TestCase
{
    /** @dataProvider tiles */
    public function testCutKeepsNeighboursOfARowTogether(array $tiles, array $expected): void
    {
        $batches = TileBatch::cut(array_map(static fn (array $tile): TileId => new TileId(...$tile), $tiles), 4, 0);

        self::assertSame($expected, array_map(static fn (TileBatch $batch): array => array_map(
            static fn (TileMeshLayout $layout): array => [$layout->tile->southDegrees, $layout->tile->westDegrees],
            $batch->layouts,
        ), $batches));
    }

    public static function tiles(): array
    {
        return [
            'none' => [[], []],
            'one' => [[[0, 5]], [[[0, 5]]]],
            'a row' => [[[0, 5], [0, 10], [0, 15]], [[[0, 5], [0, 10], [0, 15]]]],
            'a gap' => [[[0, 5], [0, 15]], [[[0, 5]], [[0, 15]]]],
            'the next column of the next row' => [[[0, 5], [5, 10]], [[[0, 5]], [[5, 10]]]],
            'two rows' => [[[0, 355], [5, 0], [5, 5]], [[[0, 355]], [[5, 0], [5, 5]]]],
        ];
    }

    public function testCutAtMostHalfAMillionSamplesAreReadAtOnce(): void
    {
        // At 64 px/deg a tile has 321 lines, and n of them 320 n + 1 samples a line: 2^19 samples are 5 tiles.
        $row = array_map(static fn (int $west): TileId => new TileId(0, $west), range(0, 60, 5));

        $sizes = array_map(static fn (TileBatch $batch): int => count($batch->layouts), TileBatch::cut($row, 64, 0));

        self::assertSame([5, 5, 3], $sizes);
    }

    public function testReadHasTheSamplesOfTheFirstAndOfTheLastTile(): void
    {
        $source = new FormulaRadiusSource(1, static fn (int $line, int $sample): float => 1000.0 * $line + $sample);
        [$batch] = TileBatch::cut([new TileId(80, 5), new TileId(80, 10)], 1, 0);

        $block = $batch->read($source);

        self::assertSame([5005.0, 5006.0], $block->line(5, 5, 2));
        self::assertSame([10014.0, 10015.0], $block->line(10, 14, 2));
    }
}
