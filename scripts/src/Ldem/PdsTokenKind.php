<?php

declare(strict_types=1);

namespace Msisf\Scripts\Ldem;

/** What a piece of a PDS3 label is. */
enum PdsTokenKind
{
    /** A keyword or an unquoted value. */
    case Word;

    /** A value in double or single quotes. */
    case Quoted;

    /** A unit in angle brackets. */
    case Unit;

    /** One of = ( ) { } and the comma. */
    case Sign;

    /** The end of the text. */
    case End;
}
