<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

use Msisf\Scripts\Ldem\LdemImage;
use Msisf\Scripts\Ldem\Resolution;

/** Makes the record of a product of which nothing is imported yet. */
final class ProductRecord
{
    public static function of(LdemImage $image, Resolution $resolution): ImportRecord
    {
        $label = $image->label;

        return new ImportRecord(
            $resolution->table(),
            $label->productId,
            ImportState::Importing,
            Schema::FORMAT_VERSION,
            $label->sha256,
            $image->sha256(),
            $label->imageBytes(),
            $label->firstLine(),
            $label->lines,
            $label->firstSample(),
            $label->lineSamples,
            0,
        );
    }
}
