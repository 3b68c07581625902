<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Pattern;

use Msisf\Scripts\Pattern\MeshFaces;
use Msisf\Scripts\Pattern\TileId;
use Msisf\Scripts\Pattern\TileMeshLayout;
use PHPUnit\Framework\TestCase;

/** At 1 px/deg a tile has 6 samples a line: vertex 6 lies south of vertex 0, and one more in front where there is a north pole. */
final class MeshFacesTest extends TestCase
{
    public function testOfPlainTileBeginsInTheNorthWest(): void
    {
        $groups = self::groups(0);

        self::assertCount(5, $groups);
        self::assertSame([[0, 6, 7], [0, 7, 1], [1, 7, 8], [1, 8, 2]], array_slice($groups[0], 0, 4));
        self::assertSame([[28, 34, 35], [28, 35, 29]], array_slice($groups[4], -2));
        self::assertSame([10, 10, 10, 10, 10], array_map('count', $groups));
    }

    public function testOfTileAtTheNorthPoleBeginsWithAFan(): void
    {
        $groups = self::groups(85);

        self::assertCount(6, $groups);
        self::assertSame([[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5], [0, 5, 6]], $groups[0]);
        self::assertSame([[1, 7, 8], [1, 8, 2]], array_slice($groups[1], 0, 2));
    }

    public function testOfTileAtTheSouthPoleEndsWithAFan(): void
    {
        // Five lines only: those south of them belong to no tile. The pole is vertex 30, the last line 24 to 29.
        $groups = self::groups(-90);

        self::assertCount(5, $groups);
        self::assertSame([[24, 30, 25], [25, 30, 26], [26, 30, 27], [27, 30, 28], [28, 30, 29]], $groups[4]);
    }

    /** @return list<list<array{int, int, int}>> */
    private static function groups(int $south): array
    {
        return iterator_to_array(MeshFaces::of(TileMeshLayout::for(new TileId($south, 0), 1, 0)), false);
    }
}
