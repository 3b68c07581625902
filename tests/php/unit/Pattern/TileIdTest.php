<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Pattern;

use Msisf\Scripts\Pattern\TileId;
use PHPUnit\Framework\TestCase;

final class TileIdTest extends TestCase
{
    /** @dataProvider tiles */
    public function testTileHasItsNameAndItsFirstSample(int $south, int $west, string $text, int $line, int $sample): void
    {
        $tile = new TileId($south, $west);

        self::assertSame([$text, $line, $sample], [$tile->rangeText(), $tile->firstLine(4), $tile->firstSample(4)]);
    }

    /** At 4 px/deg the Moon has 720 lines of 1440 samples, and a tile has 20 of each. */
    public static function tiles(): array
    {
        return [
            'north pole' => [85, 0, 'lat_85_90_lon_0_5', 0, 0],
            'north of the equator' => [0, 5, 'lat_0_5_lon_5_10', 340, 20],
            'south of the equator' => [-5, 180, 'lat_-5_0_lon_180_185', 360, 720],
            'south pole at the seam' => [-90, 355, 'lat_-90_-85_lon_355_360', 700, 1420],
        ];
    }
}
