<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

use Msisf\Scripts\Database\Connection;
use Msisf\Scripts\Ldem\Resolution;

/** How samples are asked for; the patterns are the same. */
enum QueryMethod: string
{
    /** By ranges of row and column numbers: several times faster. */
    case Grid = 'grid';

    /** By the spatial index, as in the thesis. */
    case Spatial = 'spatial';

    public function over(Connection $connection, Resolution $resolution): SampleQuery
    {
        return match ($this) {
            self::Grid => new GridQuery($connection, $resolution),
            self::Spatial => new SpatialQuery($connection, $resolution),
        };
    }
}
