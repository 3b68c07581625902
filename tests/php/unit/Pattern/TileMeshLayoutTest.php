<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Pattern;

use InvalidArgumentException;
use Msisf\Scripts\Pattern\MeshFaces;
use Msisf\Scripts\Pattern\TileId;
use Msisf\Scripts\Pattern\TileMeshLayout;
use PHPUnit\Framework\TestCase;

/** The numbers are those of docs/pattern-format.md, section 2. */
final class TileMeshLayoutTest extends TestCase
{
    /** @dataProvider layouts */
    public function testForTileHasTheSamplesOfTheFormat(int $south, int $west, int $margin, array $expected): void
    {
        $layout = TileMeshLayout::for(new TileId($south, $west), 4, $margin);

        self::assertSame($expected, [
            $layout->firstLine,
            $layout->lines,
            $layout->firstSample,
            $layout->samples,
            $layout->vertexCount(),
            $layout->faceCount(),
        ]);
    }

    public static function layouts(): array
    {
        return [
            'plain' => [0, 5, 0, [340, 21, 20, 21, 441, 800]],
            'at the seam' => [0, 355, 0, [340, 21, 1420, 21, 441, 800]],
            'north pole' => [85, 0, 0, [0, 21, 0, 21, 442, 820]],
            'south pole' => [-90, 0, 0, [700, 20, 0, 21, 421, 780]],
            'margin over the seam' => [0, 0, 2, [338, 25, 1438, 25, 625, 1152]],
            'margin that ends at the pole' => [85, 0, 2, [0, 23, 1438, 25, 576, 1080]],
        ];
    }

    public function testForMarginOfMoreThanADegreeIsRefused(): void
    {
        $this->expectException(InvalidArgumentException::class);
        TileMeshLayout::for(new TileId(0, 0), 4, 5);
    }

    /** @dataProvider layouts */
    public function testFacesEveryInnerEdgeIsSharedInOppositeDirections(int $south, int $west, int $margin): void
    {
        $layout = TileMeshLayout::for(new TileId($south, $west), 4, $margin);
        $edges = [];
        $faces = 0;
        foreach (MeshFaces::of($layout) as $group) {
            foreach ($group as [$a, $b, $c]) {
                $faces++;
                foreach ([[$a, $b], [$b, $c], [$c, $a]] as [$from, $to]) {
                    self::assertArrayNotHasKey("$from $to", $edges);
                    $edges["$from $to"] = true;
                }
            }
        }
        $open = 0;
        foreach (array_keys($edges) as $edge) {
            [$from, $to] = explode(' ', $edge);
            $open += (int) !isset($edges["$to $from"]);
        }

        self::assertSame($layout->faceCount(), $faces);
        // The border: all four sides, or three and the two legs of the fan. Euler: V - E + F = 1.
        self::assertSame(1, $layout->vertexCount() - (count($edges) + $open) / 2 + $faces);
    }
}
