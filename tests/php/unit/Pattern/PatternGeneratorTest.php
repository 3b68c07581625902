<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Pattern;

use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Pattern\PatternFormat;
use Msisf\Scripts\Pattern\PatternGenerator;
use Msisf\Scripts\Pattern\PatternRepository;
use Msisf\Scripts\Pattern\RadiusSource;
use Msisf\Scripts\Pattern\TileBatch;
use Msisf\Scripts\Pattern\TileId;
use Msisf\Tests\Support\FormulaRadiusSource;
use Msisf\Tests\Support\ImageRadiusSource;
use Msisf\Tests\Support\Parts;
use Msisf\Tests\Support\TemporaryFolder;
use PHPUnit\Framework\TestCase;

final class PatternGeneratorTest extends TestCase
{
    private TemporaryFolder $folder;

    protected function setUp(): void
    {
        $this->folder = new TemporaryFolder();
    }

    /**
     * @dataProvider goldenTiles
     * tests/golden/README.md: written by tests/reference/pattern_format.py, which shares no code with the scripts.
     */
    public function testRunRealTileIsTheGoldenFileByteForByte(int $south, int $west): void
    {
        $tile = new TileId($south, $west);
        $source = new ImageRadiusSource(Parts::ldem4Image(), 'LDEM_4', 4);

        $path = $this->make($tile, $source);

        self::assertFileEquals(Parts::root() . '/tests/golden/patterns/' . basename($path), $path);
    }

    public static function goldenTiles(): array
    {
        return ['at the seam' => [0, 355], 'north pole' => [85, 0], 'south pole at the seam' => [-90, 355]];
    }

    public function testRunMeshFormIsThatOfTheThesisInKilometres(): void
    {
        $sphere = new FormulaRadiusSource(1, static fn (): float => 1737400.0);

        $lines = file($this->make(new TileId(-5, 0), $sphere, PatternFormat::Mesh), FILE_IGNORE_NEW_LINES);

        self::assertStringStartsWith('// msisf-pattern 1 format=mesh product=TEST_GRID res=1 tile=lat_-5_0_lon_0_5 ', $lines[0]);
        // Line 90 (latitude -0.5), samples 0 and 1 (0.5 and 1.5 degrees): 1737.4 * cos, to the nearest 1/128 m; mpmath, 200 bits.
        self::assertSame(['mesh {', 'triangle {'], array_slice($lines, 1, 2));
        self::assertSame(
            '<1737.2676953125, 15.1609062500, -15.1614843750>, '
            . '<1736.7385078125, 15.1562890625, -45.4798281250>, '
            . '<1736.2094765625, 45.4642421875, -45.4798281250>',
            $lines[3],
        );
        self::assertSame(['texture { moon }', '}'], array_slice($lines, 4, 2));
        self::assertSame('}', $lines[count($lines) - 1]);
        self::assertSame(50, count(preg_grep('/^triangle \{$/', $lines)));
    }

    /** @dataProvider heightsOutOfReach */
    public function testRunSurfaceOutOfReachIsRefusedWithoutAFile(float $radius): void
    {
        $peak = static fn (int $line, int $sample): float => $line === 50 && $sample === 13 ? $radius : 1737400.0;
        try {
            $this->make(new TileId(35, 10), new FormulaRadiusSource(1, $peak));
            self::fail('The pattern was made.');
        } catch (BadInputException $exception) {
            self::assertStringContainsString("the radius $radius m", $exception->getMessage());
        }
        self::assertSame([], $this->folder->files());
    }

    public static function heightsOutOfReach(): array
    {
        return [[0.0], [-1.0], [8388608.0], [1937400.0]];
    }

    public function testRunWideAndNarrowBatchesGiveTheSameBytes(): void
    {
        $source = new FormulaRadiusSource(2, static fn (int $line, int $sample): float => 1737400.0 + ($line * 31 + $sample * 17) % 100);
        $row = array_map(static fn (int $west): TileId => new TileId(85, $west), range(0, 355, 5));
        $repository = new PatternRepository($this->folder->path('wide'), 2);
        $repository->makeFolder();
        $generator = new PatternGenerator($source, $repository, PatternFormat::Mesh2, false);
        $batches = TileBatch::cut($row, 2, 1);
        self::assertCount(1, $batches);
        self::assertSame(72, $generator->run($batches[0])->made);

        foreach ([0, 5, 180, 355] as $west) {
            $tile = new TileId(85, $west);
            self::assertFileEquals($this->make($tile, $source, PatternFormat::Mesh2, 1), $repository->pathOf($tile));
        }
    }

    private function make(
        TileId $tile,
        RadiusSource $source,
        PatternFormat $format = PatternFormat::Mesh2,
        int $marginSamples = 0,
    ): string {
        $repository = new PatternRepository($this->folder->path('single'), $source->pixelsPerDegree());
        $repository->makeFolder();
        $generator = new PatternGenerator($source, $repository, $format, false);
        foreach (TileBatch::cut([$tile], $source->pixelsPerDegree(), $marginSamples) as $batch) {
            self::assertSame(1, $generator->run($batch)->made);
        }

        return $repository->pathOf($tile);
    }
}
