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
