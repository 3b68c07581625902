<?php

declare(strict_types=1);

namespace Msisf\Scripts\Ldem;

/** How an elevation model keeps a sample (SAMPLE_TYPE and SAMPLE_BITS of its label). */
enum SampleType
{
    /** LSB_INTEGER, 16 bits: NASA's IMG products. */
    case Int16LittleEndian;

    /** MSB_INTEGER, 16 bits. */
    case Int16BigEndian;

    /** PC_REAL, 32 bits: NASA's FLOAT_IMG products. */
    case Float32LittleEndian;

    /** IEEE_REAL, 32 bits. */
    case Float32BigEndian;

    /** The type of SAMPLE_TYPE, as a word, and SAMPLE_BITS; null if it is none of these. All machines' names of a type are the same. */
    public static function find(string $word, int $bits): ?self
    {
        // Reals of a VAX are not those of IEEE 754.
        $isKnown = preg_match('/^(?:(MSB|MAC|SUN|IEEE)_|(LSB|PC)_|(VAX)_(?=INTEGER$))?(INTEGER|REAL|FLOAT)$/D', $word, $name) === 1;
        $isLittle = $isKnown && ($name[2] !== '' || $name[3] !== '');

        return match ([$isKnown ? $name[4] : '', $bits]) {
            ['INTEGER', 16] => $isLittle ? self::Int16LittleEndian : self::Int16BigEndian,
            ['REAL', 32], ['FLOAT', 32] => $isLittle ? self::Float32LittleEndian : self::Float32BigEndian,
            default => null,
        };
    }

    public function isInteger(): bool
    {
        return $this === self::Int16LittleEndian || $this === self::Int16BigEndian;
    }

    public function bytes(): int
    {
        return $this->isInteger() ? 2 : 4;
    }

    /**
     * The values of a run of samples.
     *
     * @param string $samples whole samples, at least one
     * @return list<int>|list<float>
     */
    public function decode(string $samples): array
    {
        $format = match ($this) {
            self::Int16LittleEndian => 'v*',
            self::Int16BigEndian => 'n*',
            self::Float32LittleEndian => 'g*',
            self::Float32BigEndian => 'G*',
        };
        $values = [];
        if (!$this->isInteger()) {
            return array_values(unpack($format, $samples));
        }
        foreach (unpack($format, $samples) as $value) {
            // unpack knows 16-bit numbers of a fixed byte order without a sign only.
            $values[] = $value < 32768 ? $value : $value - 65536;
        }

        return $values;
    }
}
