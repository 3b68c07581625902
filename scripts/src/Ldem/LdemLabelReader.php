<?php

declare(strict_types=1);

namespace Msisf\Scripts\Ldem;

use Msisf\Scripts\Exception\BadInputException;

/** Reads the PDS3 label of a lunar elevation model (LDEM) in simple cylindrical projection, and checks it against itself. */
final class LdemLabelReader
{
    /** Bytes: labels have a few kilobytes; of an attached label's file no more than this is looked at. */
    private const LABEL_LIMIT = 1 << 20;

    /** 180 degrees at 23 000 px/deg: no product is near. */
    private const LINE_LIMIT = 1 << 22;

    private const INTEGER_LIMIT = 0x7fffffff;

    /**
     * @param string $path a label, an image with its label attached, or an image (.IMG) with its label beside it
     * @throws BadInputException the label is missing, unreadable, incomplete, contradicts itself, or describes no
     *     cylindrical lunar elevation model
     */
    public static function readFile(string $path): LdemLabel
    {
        $labelPath = self::labelOf($path);
        $text = is_file($labelPath) ? @file_get_contents($labelPath, length: self::LABEL_LIMIT) : false;
        if ($text === false) {
            throw BadInputException::inFile($labelPath, 'missing, or can\'t be read. Give the .LBL file of an elevation model.');
        }

        return self::read($text, $labelPath);
    }

    /**
     * @param string $text begins with the label
     * @param string $labelPath for messages, and to find the image beside it
     * @throws BadInputException as readFile
     */
    public static function read(string $text, string $labelPath): LdemLabel
    {
        $root = PdsLabelParser::parse($text, $labelPath);
        $map = $root->findObject('IMAGE_MAP_PROJECTION') ?? throw self::missing($labelPath, 'IMAGE_MAP_PROJECTION');
        LdemLabelChecks::checkKind($root, $map);
        $image = $root->findObject('IMAGE') ?? throw self::missing($labelPath, 'IMAGE');
        $file = self::fileHolder($root);
        $recordBytes = $file->optionalInteger('RECORD_BYTES', 1, self::INTEGER_LIMIT);
        $records = $file->optionalInteger('FILE_RECORDS', 1, self::INTEGER_LIMIT);
        $pointer = LdemImagePointer::read($file, $recordBytes);
        [$unit, $metresPerUnit] = self::unitOf($image);
        $label = new LdemLabel(
            labelPath: $labelPath,
            imagePath: $pointer->fileName === null ? $labelPath : self::beside($labelPath, $pointer->fileName),
            imageOffset: $pointer->offset,
            fileBytes: $recordBytes === null || $records === null ? null : $recordBytes * $records,
            productId: self::productIdOf($root),
            pixelsPerDegree: self::resolutionOf($map),
            lines: $image->requiredInteger('LINES', 1, self::LINE_LIMIT),
            lineSamples: $image->requiredInteger('LINE_SAMPLES', 1, 2 * self::LINE_LIMIT),
            sampleType: self::sampleTypeOf($image),
            scalingFactor: $metresPerUnit * $image->requiredNumber('SCALING_FACTOR', $unit),
            offset: $metresPerUnit * $image->requiredNumber('OFFSET', $unit),
            minimum: $image->requiredNumber('MINIMUM'),
            maximum: $image->requiredNumber('MAXIMUM'),
            northDegrees: $map->requiredNumber('MAXIMUM_LATITUDE', PdsUnit::DEGREE),
            southDegrees: $map->requiredNumber('MINIMUM_LATITUDE', PdsUnit::DEGREE),
            westDegrees: $map->requiredNumber('WESTERNMOST_LONGITUDE', PdsUnit::DEGREE),
            eastDegrees: $map->requiredNumber('EASTERNMOST_LONGITUDE', PdsUnit::DEGREE),
            sha256: hash('sha256', $pointer->fileName === null ? substr($text, 0, $pointer->offset) : $text),
        );
        LdemLabelChecks::checkCover($label, $image, $map);
        LdemLabelChecks::checkSamples($label, $image, $map);
        LdemLabelChecks::checkRecords($label, $file, $pointer->fileName !== null);

        return $label;
    }

    private static function labelOf(string $path): string
    {
        if (strcasecmp(pathinfo($path, PATHINFO_EXTENSION), 'IMG') !== 0) {
            return $path;
        }

        // An image without a label beside it can have its label attached.
        return FileNames::findIgnoringCase(substr($path, 0, -4) . '.LBL') ?? $path;
    }

    private static function beside(string $labelPath, string $fileName): string
    {
        $folder = dirname($labelPath);

        return $folder === '.' && !str_starts_with($labelPath, '.') ? $fileName : rtrim($folder, '/') . "/$fileName";
    }

    /** The object that describes the image's file: labels of products that exist as .JP2 too have one for each. */
    private static function fileHolder(PdsObject $root): PdsObject
    {
        foreach (['UNCOMPRESSED_FILE', 'FILE'] as $name) {
            $candidate = $root->findObject($name);
            if ($candidate?->find('^IMAGE') !== null) {
                return $candidate;
            }
        }

        return $root;
    }

    /** @return array{string, float} the unit of the heights, and its metres */
    private static function unitOf(PdsObject $image): array
    {
        return match (PdsUnit::of($image->requiredText('UNIT'))) {
            PdsUnit::METRE => [PdsUnit::METRE, 1.0],
            PdsUnit::KILOMETRE => [PdsUnit::KILOMETRE, 1000.0],
            default => throw $image->unfit('UNIT', $image->required('UNIT'), 'METER or KILOMETER is needed'),
        };
    }

    private static function sampleTypeOf(PdsObject $image): SampleType
    {
        $bits = $image->requiredInteger('SAMPLE_BITS', 1, 64);
        $image->requiredText('SAMPLE_TYPE');

        return SampleType::find($image->required('SAMPLE_TYPE')->word(), $bits) ?? throw $image->unfit(
            'SAMPLE_TYPE',
            $image->required('SAMPLE_TYPE'),
            "with SAMPLE_BITS = $bits it is not known; 16-bit LSB_INTEGER or MSB_INTEGER, or 32-bit PC_REAL or IEEE_REAL are needed"
        );
    }

    private static function resolutionOf(PdsObject $map): int
    {
        $map->requiredNumber('MAP_RESOLUTION', PdsUnit::PIXELS_PER_DEGREE);

        return $map->requiredInteger('MAP_RESOLUTION', 1, intdiv(self::LINE_LIMIT, 180));
    }

    private static function productIdOf(PdsObject $root): string
    {
        $productId = $root->requiredText('PRODUCT_ID');
        if (preg_match('/^[0-9A-Za-z_.-]{1,40}$/D', $productId) !== 1) {
            throw $root->unfit('PRODUCT_ID', $root->required('PRODUCT_ID'), "1 to 40 letters, digits, '_', '-' or '.' are needed");
        }

        return $productId;
    }

    private static function missing(string $labelPath, string $name): BadInputException
    {
        return BadInputException::inFile(
            $labelPath,
            "no OBJECT = $name. Give the label of a LDEM product in SIMPLE CYLINDRICAL projection."
        );
    }
}
