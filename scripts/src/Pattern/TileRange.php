<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

use Msisf\Scripts\Exception\UsageException;

/** A range of latitudes and longitudes, and the tiles that it touches. */
final class TileRange
{
    private function __construct(
        private readonly float $south,
        private readonly float $north,
        private readonly float $west,
        private readonly float $east,
    ) {
    }

    public static function wholeMoon(): self
    {
        return new self(-90.0, 90.0, 0.0, 360.0);
    }

    /**
     * The range of two options; a range that is not given has no limit.
     *
     * @param ?string $latitudes  "south:north" in degrees, -90 to 90, or one latitude
     * @param ?string $longitudes "west:east" in degrees, 0 to 360, or one longitude; west > east runs over the prime meridian
     */
    public static function parse(?string $latitudes, ?string $longitudes): self
    {
        [$south, $north] = $latitudes === null ? [-90.0, 90.0] : self::limits('--lat', $latitudes, -90.0, 90.0);
        [$west, $east] = $longitudes === null ? [0.0, 360.0] : self::limits('--lon', $longitudes, 0.0, 360.0);
        if ($south > $north) {
            throw new UsageException("--lat $latitudes: runs from north to south. Give the smaller latitude first.");
        }

        return new self($south, $north, $west, $east);
    }

    /** @return list<TileId> by latitude, then longitude */
    public function tiles(): array
    {
        $tiles = [];
        for ($south = -90; $south < 90; $south += TileId::SIZE_DEGREES) {
            for ($west = 0; $west < 360; $west += TileId::SIZE_DEGREES) {
                if ($this->touchesLatitude($south) && $this->touchesLongitude($west)) {
                    $tiles[] = new TileId($south, $west);
                }
            }
        }

        return $tiles;
    }

    private function touchesLatitude(int $tileSouth): bool
    {
        return self::touch($tileSouth, $this->south, $this->north, 90.0);
    }

    private function touchesLongitude(int $tileWest): bool
    {
        if ($this->west <= $this->east) {
            // 360 alone is the prime meridian, the first column.
            return $this->west === 360.0 ? $tileWest === 0 : self::touch($tileWest, $this->west, $this->east, 360.0);
        }

        return self::touch($tileWest, $this->west, 360.0, 360.0)
            || ($this->east > 0.0 && self::touch($tileWest, 0.0, $this->east, 360.0));
    }

    /** Whether [from, to] and the tile share more than a border; a range of one point belongs to one tile. */
    private static function touch(int $start, float $from, float $to, float $last): bool
    {
        $end = $start + TileId::SIZE_DEGREES;
        if ($from === $to) {
            return $start <= $from && ($from < $end || ($from === $last && $last === (float) $end));
        }

        return $from < $end && $to > $start;
    }

    /** @return array{float, float} */
    private static function limits(string $option, string $text, float $least, float $greatest): array
    {
        $number = '[+-]?(?:\d+(?:\.\d*)?|\.\d+)';
        if (preg_match("/^($number)(?::($number))?\$/D", $text, $parts) !== 1) {
            throw new UsageException("$option $text: not a range. Give degrees as FROM:TO, for example $option 0:20.");
        }
        $limits = [(float) $parts[1], (float) ($parts[2] ?? $parts[1])];
        foreach ($limits as $limit) {
            if ($limit < $least || $limit > $greatest) {
                throw new UsageException("$option $text: $limit is out of range; $least to $greatest degrees are possible.");
            }
        }

        return $limits;
    }
}
