<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Pattern;

use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Pattern\Lattice;
use Msisf\Scripts\Pattern\TileId;
use PHPUnit\Framework\TestCase;

final class LatticeTest extends TestCase
{
    /** @dataProvider halfSteps */
    public function testNearestHalfStepsGoUpAlsoBelowZero(float $radius, float $cosine, int $expected): void
    {
        self::assertSame([$expected, 0, 0], Lattice::nearest($radius, [0.0, 1.0], [0.0, $cosine]));
    }

    /** A step is 1/128 m. */
    public static function halfSteps(): array
    {
        return [
            'on the lattice' => [3 / 128, 1.0, 3],
            'half a step' => [2.5 / 128, 1.0, 3],
            'less than half a step' => [2.4375 / 128, 1.0, 2],
            'half a step below zero' => [2.5 / 128, -1.0, -2],
            'more than half a step below zero' => [2.5625 / 128, -1.0, -3],
        ];
    }

    public function testNearestAxesAreThoseOfTheMoon(): void
    {
        // Sine 0.6, cosine 0.8 for both: z is up, x at longitude 0.
        self::assertSame([8192, 6144, 7680], Lattice::nearest(100.0, [0.6, 0.8], [0.6, 0.8]));
    }

    /** @dataProvider origins */
    public function testOriginOfIsTheLatticePointOfTheTilesMiddle(int $south, int $west, array $expected): void
    {
        self::assertSame($expected, Lattice::originOf(new TileId($south, $west)));
    }

    /** mpmath with 300 bits: 128 * 1737400 m in the direction of the middle, rounded. */
    public static function origins(): array
    {
        return [
            [0, 0, [221964075, 9691161, 9700393]],
            [85, 355, [9691161, -423125, 222175537]],
            [-90, 180, [-9691161, -423125, -222175537]],
            [-5, 90, [-9691161, 221964075, -9700393]],
        ];
    }

    /** @dataProvider reaches */
    public function testRequireReachRefusesWhatA32BitFloatCannotHold(array $radii, int $originX, ?float $refused): void
    {
        if ($refused !== null) {
            $this->expectException(BadInputException::class);
            $this->expectExceptionMessage("the radius $refused m");
        }
        Lattice::requireReach([$originX, 0, 0], $radii, [0.0, 1.0], [0.0], [1.0]);
        self::assertNull($refused);
    }

    /** 2^24 steps are 131072 m. */
    public static function reaches(): array
    {
        return [
            'the farthest offset' => [[131072.0 - 1 / 128, 1.0], 0, null],
            'a step more' => [[1.0, 131072.0], 0, 131072.0],
            'on the other side' => [[1.0], 128 + (1 << 24), 1.0],
            'nearly on the other side' => [[1.0], 127 + (1 << 24), null],
            'nothing' => [[5.0, 0.0], 0, 0.0],
            'below zero' => [[-1.0, 5.0], 0, -1.0],
            'too large for whole steps' => [[8388608.0], 1 << 30, 8388608.0],
        ];
    }
}
