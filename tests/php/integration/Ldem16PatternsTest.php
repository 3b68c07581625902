<?php

declare(strict_types=1);

namespace Msisf\Tests\Integration;

use Msisf\Scripts\Database\Connection;
use Msisf\Scripts\Database\ConnectionSettings;
use Msisf\Scripts\Ldem\Resolution;
use Msisf\Scripts\Pattern\TileId;
use Msisf\Scripts\Pattern\TileMeshLayout;
use Msisf\Tests\Support\ImageRadiusSource;
use Msisf\Tests\Support\Parts;
use Msisf\Tests\Support\ReferencePatterns;
use Msisf\Tests\Support\ScriptRun;
use Msisf\Tests\Support\TemporaryFolder;
use Msisf\Tests\Support\TestLength;
use PHPUnit\Framework\TestCase;

/**
 * Tiles of a synthetic LDEM_16 at the poles, the seam and random places. Only their samples are in the table:
 * the whole model would take minutes.
 */
final class Ldem16PatternsTest extends TestCase
{
    private const RESOLUTION = Resolution::Px16;
    private const PRODUCT = 'LDEM_16_SYNTHETIC';
    private const RANDOM_TILES = 2;
    private const RANDOM_TILES_OF_LONG_TESTS = 100;

    public function testTilesAtPolesSeamAndRandomPlacesAreThoseOfMsis(): void
    {
        $folder = new TemporaryFolder();
        $synthesis = ScriptRun::start([
            Parts::msis(), 'ldem', 'synthesize', '--batch', '--res', '16', '--seed', '20120222', '--output-dir', $folder->path('ldem'),
        ])->wait();
        self::assertSame(0, $synthesis->exitCode, $synthesis->errors);
        $image = $folder->path('ldem/' . self::PRODUCT);
        $tiles = self::tiles();
        $environment = ImportedModels::withTables(self::RESOLUTION, self::PRODUCT);
        self::insert($environment, new ImageRadiusSource("$image.IMG", self::PRODUCT, 16), $tiles);

        foreach ($tiles as $tile) {
            $latitude = $tile->southDegrees + 2.5;
            $longitude = $tile->westDegrees + 2.5;
            $run = ScriptRun::start([
                PHP_BINARY, Parts::root() . '/scripts/generate_pattern.php', '--res=16', "--lat=$latitude", "--lon=$longitude",
                '--repository', $folder->path('php'),
            ], $environment)->wait();
            self::assertSame(0, $run->exitCode, $run->errors);
        }

        file_put_contents($folder->path('states.tab'), implode('', array_map(self::stateOver(...), $tiles)));
        $reference = new ReferencePatterns("$image.LBL", 16, [
            '--for-batch', $folder->path('states.tab'), '--fov', '1', '--width', '16', '--height', '16', '--lod', 'off', '--ignore-sun',
        ]);
        self::assertCount(count($tiles), glob($folder->path('php/16/*')));
        self::assertSame([], $reference->differencesIn($folder->path('php'), wantAll: false));
    }

    /** A line of a batch file: a camera low over the middle of a tile, which looks straight down: msis makes that tile, and beside a pole neighbours. */
    private static function stateOver(TileId $tile): string
    {
        $latitude = deg2rad($tile->southDegrees + 2.5);
        $longitude = deg2rad($tile->westDegrees + 2.5);
        $up = [cos($latitude) * cos($longitude), cos($latitude) * sin($longitude), sin($latitude)];
        $turn = [0.0, -$up[2], $up[1], 1.0 + $up[0]]; // from looking along -x to looking along -up
        $length = sqrt(array_sum(array_map(static fn (float $part): float => $part ** 2, $turn)));
        $state = [55289.0, ...array_map(static fn (float $part): float => 1.76e6 * $part, $up)];

        return vsprintf(str_repeat('%.15E ', 8) . "\n", [...$state, ...array_map(static fn (float $part): float => $part / $length, $turn)]);
    }

    /** @return array<string, TileId> */
    private static function tiles(): array
    {
        $places = [[85, 0], [85, 355], [85, 180], [-90, 0], [-90, 355], [-90, 90], [0, 355], [-5, 355], [0, 0], [40, 355]];
        mt_srand(20120222);
        $random = TestLength::of(self::RANDOM_TILES, self::RANDOM_TILES_OF_LONG_TESTS);
        for ($i = 0; $i < $random; $i++) {
            $places[] = [5 * mt_rand(-18, 17), 5 * mt_rand(0, 71)];
        }
        $tiles = [];
        foreach ($places as [$south, $west]) {
            $tile = new TileId($south, $west);
            $tiles[$tile->rangeText()] = $tile;
        }

        return $tiles;
    }

    /**
     * Puts the samples of tiles into the table; positions play no part in a pattern, so they stay 0.
     *
     * @param array<string, string> $environment
     * @param array<string, TileId> $tiles
     */
    private static function insert(array $environment, ImageRadiusSource $source, array $tiles): void
    {
        $connection = Connection::open(ConnectionSettings::read(null, $environment));
        $connection->useDatabase();
        $connection->execute('ALTER TABLE ldem_16 DROP KEY point_index'); // not asked, and slow to fill
        $lastLine = self::RESOLUTION->lines() - 1;
        $all = self::RESOLUTION->lineSamples();
        $runs = [[0, 0, $all], [$lastLine, 0, $all]]; // the poles' radii are means of these lines
        foreach ($tiles as $tile) {
            $layout = TileMeshLayout::for($tile, 16, 0);
            for ($line = $layout->firstLine; $line < $layout->firstLine + $layout->lines; $line++) {
                $before = min($layout->samples, $all - $layout->firstSample);
                $runs[] = [$line, $layout->firstSample, $before];
                if ($before < $layout->samples) {
                    $runs[] = [$line, 0, $layout->samples - $before];
                }
            }
        }
        foreach (array_chunk($runs, 40) as $chunk) {
            $rows = [];
            foreach ($chunk as [$line, $sample, $count]) {
                foreach ($source->radii($line, 1, $sample, $count) as $offset => $radius) {
                    $column = $sample + $offset;
                    $rows[] = "($line,$column,0,0,{$radius}e0,0,0,0,POINT(0,0))";
                }
            }
            $connection->execute('INSERT IGNORE INTO ldem_16 VALUES ' . implode(',', $rows));
        }
    }
}
