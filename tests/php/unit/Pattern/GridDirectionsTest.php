<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Pattern;

use Msisf\Scripts\Pattern\GridDirections;
use PHPUnit\Framework\TestCase;

/** Expected bits: mpmath with 300 bits, rounded once. At 1 px/deg line 0 is latitude 89.5, sample 0 longitude 0.5 degrees. */
final class GridDirectionsTest extends TestCase
{
    private const SIN_HALF = '3f81df37c4954c21';

    private const COS_HALF = '3fefffb02599c9cd';

    private const MINUS_SIN_HALF = 'bf81df37c4954c21';

    private const MINUS_COS_HALF = 'bfefffb02599c9cd';

    /** @dataProvider latitudes */
    public function testLatitudeRunsFromNorthToSouth(int $line, string $sine, string $cosine): void
    {
        self::assertSame([$sine, $cosine], self::bits((new GridDirections(1))->latitude($line)));
    }

    public static function latitudes(): array
    {
        return [
            '89.5' => [0, self::COS_HALF, self::SIN_HALF],
            '88.5' => [1, '3feffd315bbf4275', '3f9ace214390ca91'],
            '0.5' => [89, self::SIN_HALF, self::COS_HALF],
            '-0.5' => [90, self::MINUS_SIN_HALF, self::COS_HALF],
            '-89.5' => [179, self::MINUS_COS_HALF, self::SIN_HALF],
        ];
    }

    /** @dataProvider longitudes */
    public function testLongitudeRunsEastwardThroughAllQuarters(int $sample, string $sine, string $cosine): void
    {
        self::assertSame([$sine, $cosine], self::bits((new GridDirections(1))->longitude($sample)));
    }

    public static function longitudes(): array
    {
        return [
            '0.5' => [0, self::SIN_HALF, self::COS_HALF],
            '89.5' => [89, self::COS_HALF, self::SIN_HALF],
            '90.5' => [90, self::COS_HALF, self::MINUS_SIN_HALF],
            '180.5' => [180, self::MINUS_SIN_HALF, self::MINUS_COS_HALF],
            '270.5' => [270, self::MINUS_COS_HALF, self::SIN_HALF],
            '359.5' => [359, self::MINUS_SIN_HALF, self::COS_HALF],
        ];
    }

    /** @return array{string, string} */
    private static function bits(array $pair): array
    {
        return [bin2hex(pack('E', $pair[0])), bin2hex(pack('E', $pair[1]))];
    }
}
