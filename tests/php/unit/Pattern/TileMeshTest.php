<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Pattern;

use Msisf\Scripts\Pattern\GridDirections;
use Msisf\Scripts\Pattern\PatternFormat;
use Msisf\Scripts\Pattern\PatternHeader;
use Msisf\Scripts\Pattern\SampleBlock;
use Msisf\Scripts\Pattern\TileId;
use Msisf\Scripts\Pattern\TileMesh;
use Msisf\Scripts\Pattern\TileMeshLayout;
use Msisf\Scripts\Pattern\TileRadii;
use Msisf\Tests\Support\FormulaRadiusSource;
use PHPUnit\Framework\TestCase;

/** Radii, vertices and header of the tile at the north pole at 1 px/deg: six lines of six samples, and the pole. */
final class TileMeshTest extends TestCase
{
    /** Python: hashlib.sha256(struct.pack('<37d', 9.0, *(1737400.0 + i for i in range(36)))).hexdigest() */
    private const HASH = '401cfe1a1c6f68d7c9b76ddb6ad7a953e88b50e8c489dddf4e8b14a1a1e0a205';

    public function testRadiiRowsAreThoseOfTheTileAndThePoleComesFirst(): void
    {
        $radii = self::radii(9.0);

        self::assertSame([1737406.0, 1737407.0, 1737408.0, 1737409.0, 1737410.0, 1737411.0], $radii->row(1));
        self::assertSame(self::HASH, $radii->hash());
        self::assertNotSame(self::HASH, self::radii(9.5)->hash());
    }

    public function testHeaderSaysWhatTheFileIsMadeOf(): void
    {
        $radii = self::radii(9.0);

        self::assertSame(
            '// msisf-pattern 1 format=mesh2 product=LDEM_X res=1 tile=lat_85_90_lon_0_5 margin-samples=0 samples-sha256='
            . self::HASH . ' vertices=37 faces=55 bytes=',
            PatternHeader::withoutLength($radii->layout, $radii, 'LDEM_X', PatternFormat::Mesh2),
        );
        self::assertSame('000000000000', PatternHeader::length(0));
        self::assertSame('001234567890', PatternHeader::length(1234567890));
    }

    public function testVertexLinesPoleThenLinesFromTheNorthRelativeToTheOrigin(): void
    {
        $radii = self::radii(1737400.0);
        $mesh = new TileMesh($radii->layout, $radii, new GridDirections(1));

        $lines = iterator_to_array($mesh->vertexLines(';'), false);

        // Origin: longitude 2.5, latitude 87.5 degrees; the pole is (0, 0, 222387200) steps. mpmath, 300 bits.
        self::assertSame([9691161, 423125, 222175537], $mesh->origin);
        self::assertSame('-9691161,-423125,211663', $lines[0]);
        self::assertSame([1, 6, 6, 6, 6, 6, 6], array_map(static fn (string $line): int => count(explode(';', $line)), $lines));
        self::assertSame('-7750565,-406190,203195', explode(';', $lines[1])[0]);
        self::assertSame('11526006,1619856,-807704', explode(';', $lines[6])[5]);
    }

    private static function radii(float $northPole): TileRadii
    {
        $layout = TileMeshLayout::for(new TileId(85, 0), 1, 0);
        $source = new FormulaRadiusSource(1, static fn (int $line, int $sample): float => 1737400.0 + 6 * $line + $sample);

        return new TileRadii($layout, SampleBlock::read($source, 0, 6, 0, 6), $northPole, null);
    }
}
