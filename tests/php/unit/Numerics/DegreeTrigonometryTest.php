<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Numerics;

use InvalidArgumentException;
use Msisf\Scripts\Numerics\DegreeTrigonometry;
use PHPUnit\Framework\TestCase;

final class DegreeTrigonometryTest extends TestCase
{
    /** @dataProvider trueSines */
    public function testSinAgainstMpmathIsCorrectlyRounded(int $numerator, int $denominator, string $expectedBits): void
    {
        self::assertSame($expectedBits, self::bits(DegreeTrigonometry::sin($numerator, $denominator)));
    }

    /** tests/reference/degree_trigonometry.py: mpmath with 200 bits, rounded once. */
    public static function trueSines(): array
    {
        return [
            [1, 8, '3f61df45b4769082'],
            [1, 2048, '3ee1df46a251af5d'],
            [5, 2, '3fa65547c4694e11'],
            [89, 2, '3fe66dd943f43372'],
            [45, 1, '3fe6a09e667f3bcd'],
            [91, 2, '3fe6d2f29b1f2f46'],
            [1, 3, '3f77d4555e817be2'],
            [359999, 8000, '3fe6a09b2a485eb0'],
        ];
    }

    /** @dataProvider quarters */
    public function testSinCosWholeQuarterIsExactAndNeverMinusZero(int $degrees, float $sine, float $cosine): void
    {
        self::assertSame(self::bits($sine), self::bits(DegreeTrigonometry::sin($degrees, 1)));
        self::assertSame(self::bits($cosine), self::bits(DegreeTrigonometry::cos($degrees, 1)));
    }

    public static function quarters(): array
    {
        return [[0, 0.0, 1.0], [90, 1.0, 0.0], [180, 0.0, -1.0], [270, -1.0, 0.0], [360, 0.0, 1.0], [-90, -1.0, 0.0]];
    }

    public function testSinThirtyDegreesIsHalf(): void
    {
        self::assertSame(0.5, DegreeTrigonometry::sin(30, 1));
        self::assertSame(0.5, DegreeTrigonometry::sin(150 * 7, 7));
        self::assertSame(-0.5, DegreeTrigonometry::sin(-30, 1));
        self::assertSame(-0.5, DegreeTrigonometry::cos(240, 1));
    }

    public function testSinCosAnyAngleKeepsSymmetriesBitForBit(): void
    {
        mt_srand(20120222);
        for ($i = 0; $i < 500; $i++) {
            $n = mt_rand(-100_000_000, 100_000_000);
            $d = mt_rand(1, 5000);
            $sine = DegreeTrigonometry::sin($n, $d);
            self::assertSame($sine, DegreeTrigonometry::sin(180 * $d - $n, $d), "$n / $d");
            self::assertSame($sine, 0.0 - DegreeTrigonometry::sin(-$n, $d), "$n / $d");
            self::assertSame($sine, DegreeTrigonometry::cos(90 * $d - $n, $d), "$n / $d");
            // 4e-16: 2 ulps of 1.
            self::assertEqualsWithDelta(1.0, $sine ** 2 + DegreeTrigonometry::cos($n, $d) ** 2, 4e-16, "$n / $d");
        }
    }

    public function testSinDenominatorBelowOneIsRefused(): void
    {
        $this->expectException(InvalidArgumentException::class);
        DegreeTrigonometry::sin(1, 0);
    }

    private static function bits(float $value): string
    {
        return bin2hex(pack('E', $value));
    }
}
