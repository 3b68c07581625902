<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Ldem;

use Msisf\Scripts\Ldem\SampleType;
use PHPUnit\Framework\TestCase;

final class SampleTypeTest extends TestCase
{
    /** @dataProvider samples */
    public function testDecodeBytesAreReadInOrderWithSign(SampleType $type, string $hexadecimal, array $expected): void
    {
        self::assertSame($expected, $type->decode(hex2bin($hexadecimal)));
    }

    public static function samples(): array
    {
        return [
            'integers, low byte first' => [SampleType::Int16LittleEndian, '0000ff7f0080ffff3412', [0, 32767, -32768, -1, 0x1234]],
            'integers, high byte first' => [SampleType::Int16BigEndian, '00007fff8000ffff1234', [0, 32767, -32768, -1, 0x1234]],
            'floats, low byte first' => [SampleType::Float32LittleEndian, '0000803f000020c1', [1.0, -10.0]],
            'floats, high byte first' => [SampleType::Float32BigEndian, '3f800000c1200000', [1.0, -10.0]],
            'one sample' => [SampleType::Int16LittleEndian, '0100', [1]],
        ];
    }

    public function testBytesOfIntegersAndFloats(): void
    {
        $sizes = array_map(static fn (SampleType $type): array => [$type->isInteger(), $type->bytes()], SampleType::cases());

        self::assertSame([[true, 2], [true, 2], [false, 4], [false, 4]], $sizes);
    }
}
