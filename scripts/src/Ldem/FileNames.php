<?php

declare(strict_types=1);

namespace Msisf\Scripts\Ldem;

/** Archives write names in capitals, downloads often don't keep them. */
final class FileNames
{
    /** The file of this path, or the first one whose name differs in capitals only; null if there is none. */
    public static function findIgnoringCase(string $path): ?string
    {
        if (is_file($path)) {
            return $path;
        }
        $folder = dirname($path);
        foreach (is_dir($folder) ? scandir($folder) : [] as $name) {
            if (strcasecmp($name, basename($path)) === 0 && is_file("$folder/$name")) {
                return "$folder/$name";
            }
        }

        return null;
    }
}
