<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Pattern;

use Msisf\Scripts\Exception\UsageException;
use Msisf\Scripts\Pattern\TileId;
use Msisf\Scripts\Pattern\TileRange;
use PHPUnit\Framework\TestCase;

final class TileRangeTest extends TestCase
{
    public function testTilesWholeMoonAreSortedByLatitudeThenLongitude(): void
    {
        $names = self::names(TileRange::parse(null, null));

        self::assertCount(2592, array_unique($names));
        self::assertSame(
            ['lat_-90_-85_lon_0_5', 'lat_-90_-85_lon_5_10', 'lat_-85_-80_lon_0_5', 'lat_85_90_lon_355_360'],
            [$names[0], $names[1], $names[72], $names[2591]],
        );
    }

    /** @dataProvider ranges */
    public function testTilesOfARangeAreThoseItTouches(?string $latitudes, ?string $longitudes, array $expected): void
    {
        self::assertSame($expected, self::names(TileRange::parse($latitudes, $longitudes)));
    }

    public static function ranges(): array
    {
        return [
            'borders belong to one side' => ['0:5', '10:20', ['lat_0_5_lon_10_15', 'lat_0_5_lon_15_20']],
            'a little of a tile' => ['-0.25:4', '9.9:10.1', [
                'lat_-5_0_lon_5_10', 'lat_-5_0_lon_10_15', 'lat_0_5_lon_5_10', 'lat_0_5_lon_10_15',
            ]],
            'over the prime meridian' => ['0:1', '355:5', ['lat_0_5_lon_0_5', 'lat_0_5_lon_355_360']],
            'up to the prime meridian' => ['0:1', '357:360', ['lat_0_5_lon_355_360']],
            'from 355 to 0' => ['0:1', '355:0', ['lat_0_5_lon_355_360']],
            'a point' => ['-3', '+7.5', ['lat_-5_0_lon_5_10']],
            'a point on a corner' => ['5', '5', ['lat_5_10_lon_5_10']],
            'the north pole' => ['90', '0', ['lat_85_90_lon_0_5']],
            'longitude 360' => ['-90', '360', ['lat_-90_-85_lon_0_5']],
        ];
    }

    /** @dataProvider wrongRanges */
    public function testParseWrongRangeIsRefused(?string $latitudes, ?string $longitudes, string $message): void
    {
        $this->expectException(UsageException::class);
        $this->expectExceptionMessage($message);
        TileRange::parse($latitudes, $longitudes);
    }

    public static function wrongRanges(): array
    {
        return [
            ['5:0', null, 'north to south'],
            ['-91:0', null, '-90 to 90'],
            [null, '0:361', '0 to 360'],
            [null, '-5:5', '0 to 360'],
            ['1:2:3', null, 'not a range'],
            ['', null, 'not a range'],
            ['1e1', null, 'not a range'],
            ['NAN', null, 'not a range'],
            ['0:5; DROP TABLE ldem_4', null, 'not a range'],
            ["0:5\n", null, 'not a range'],
        ];
    }

    /** @return list<string> */
    private static function names(TileRange $range): array
    {
        return array_map(static fn (TileId $tile): string => $tile->rangeText(), $range->tiles());
    }
}
