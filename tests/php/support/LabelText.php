<?php

declare(strict_types=1);

namespace Msisf\Tests\Support;

/** Small products of LDEM_4's form for tests: a label and an image beside it. */
final class LabelText
{
    /**
     * Writes a part of the Moon at 4 px/deg as PRODUCT.LBL and PRODUCT.IMG.
     *
     * @param array{int, int, int, int} $borders north, south, west, east, degrees
     * @param string $samples the image's bytes
     * @param array<string, string> $changes other values of keywords
     * @return string path of the label
     */
    public static function writeProduct(
        TemporaryFolder $folder,
        string $productId,
        array $borders,
        string $samples,
        array $changes = [],
    ): string {
        file_put_contents($folder->path("$productId.IMG"), $samples);
        file_put_contents($folder->path("$productId.LBL"), self::of($productId, $borders, $changes));

        return $folder->path("$productId.LBL");
    }

    /**
     * @param array{int, int, int, int} $borders north, south, west, east, degrees
     * @param array<string, string> $changes other values of keywords; '' leaves the keyword out
     */
    public static function of(string $productId, array $borders, array $changes = []): string
    {
        [$north, $south, $west, $east] = $borders;
        $lines = 4 * ($north - $south);
        $samples = 4 * ($east - $west);
        $sampleBytes = intdiv((int) ($changes['SAMPLE_BITS'] ?? '16'), 8);
        $objects = [
            'FILE' => ['FILE_RECORDS' => $lines, 'RECORD_BYTES' => $sampleBytes * $samples, '^IMAGE' => "\"$productId.IMG\""],
            'IMAGE' => [
                'LINES' => $lines, 'LINE_SAMPLES' => $samples, 'MINIMUM' => -20000, 'MAXIMUM' => 22000,
                'SAMPLE_TYPE' => 'LSB_INTEGER', 'SAMPLE_BITS' => 16, 'UNIT' => 'METER', 'SCALING_FACTOR' => 0.5, 'OFFSET' => '1737400.',
            ],
            'IMAGE_MAP_PROJECTION' => [
                'MAP_PROJECTION_TYPE' => '"SIMPLE CYLINDRICAL"', 'MAP_RESOLUTION' => '4 <pix/deg>', 'A_AXIS_RADIUS' => '1737.4 <km>',
                'POSITIVE_LONGITUDE_DIRECTION' => '"EAST"', 'CENTER_LATITUDE' => '0. <deg>', 'CENTER_LONGITUDE' => '180. <deg>',
                'MAXIMUM_LATITUDE' => "$north <deg>", 'MINIMUM_LATITUDE' => "$south <deg>",
                'WESTERNMOST_LONGITUDE' => "$west <deg>", 'EASTERNMOST_LONGITUDE' => "$east <deg>",
                'LINE_PROJECTION_OFFSET' => 4 * $north - 0.5 . ' <pix>', 'SAMPLE_PROJECTION_OFFSET' => 4 * (180 - $west) - 0.5 . ' <pix>',
                'COORDINATE_SYSTEM_NAME' => '"MEAN EARTH/POLAR AXIS OF DE421"',
            ],
        ];
        $text = "PDS_VERSION_ID = \"PDS3\"\r\n/* a test's */\r\nPRODUCT_ID = \"$productId\"\r\nTARGET_NAME = MOON\r\n";
        foreach ($objects as $name => $keywords) {
            $text .= "OBJECT = $name\r\n";
            foreach ($keywords as $keyword => $value) {
                $value = $changes[$keyword] ?? $value;
                $text .= $value === '' ? '' : "  $keyword = $value\r\n";
            }
            $text .= "END_OBJECT = $name\r\n";
        }

        return $text . "END\r\n";
    }

    /** Little-endian 16-bit samples of a pattern that differs everywhere. */
    public static function samples(int $count, int $seed = 1): string
    {
        $bytes = '';
        for ($i = 0; $i < $count; $i++) {
            $bytes .= pack('v', (($i * 7919 + $seed * 104729) % 20011 - 10000) & 0xffff);
        }

        return $bytes;
    }
}
