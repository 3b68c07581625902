<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

use Msisf\Scripts\Exception\ExternalPartException;

/** A way to ask the database for a rectangle of samples. */
interface SampleQuery
{
    /**
     * The samples that the table has; the parameters are those of RadiusSource::radii.
     *
     * @return array<int, float> m, line by line from the north, in a line from the west; shorter if samples are missing
     * @throws ExternalPartException the database failed
     */
    public function radii(int $line, int $lines, int $sample, int $samples): array;
}
