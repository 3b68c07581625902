<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

/** How a pattern file writes its mesh (docs/pattern-format.md). */
enum PatternFormat: string
{
    /** POV-Ray's mesh2 with whole lattice steps: exact, the default. */
    case Mesh2 = 'mesh2';

    /** POV-Ray's mesh with one triangle after the other in kilometres, as in the thesis: larger, and rounded by POV-Ray. */
    case Mesh = 'mesh';
}
