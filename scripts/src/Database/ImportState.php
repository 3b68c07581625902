<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

/** How far a product is; the values stand in the column state. */
enum ImportState: string
{
    /** Its first rows_done lines are in the table. */
    case Importing = 'importing';

    /** All of it is in the table. */
    case Complete = 'complete';

    /** Its rows are being deleted, in any order. */
    case Removing = 'removing';
}
