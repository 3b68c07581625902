<?php

declare(strict_types=1);

namespace Msisf\Tests\Support;

use PHPUnit\Framework\Assert;

/** Where the real parts are that tests work with. A missing one skips the test by name; with CI=true it fails. */
final class Parts
{
    /** The folder that holds MSISF.sln. */
    public static function root(): string
    {
        return dirname(__DIR__, 3);
    }

    /** The image of the real LOLA model at 4 px/deg; its label is beside it. */
    public static function ldem4Image(): string
    {
        return self::first('LDEM_4.IMG', [
            self::root() . '/input/ldem/LDEM_4.IMG',
            dirname(self::root()) . '/shared/ldem/LDEM_4.IMG',
        ]);
    }

    /** The C# program. */
    public static function msis(): string
    {
        return self::first('publish/msis', [self::root() . '/publish/msis']);
    }

    /** POV-Ray, for msis. */
    public static function povray(): string
    {
        return self::program('povray');
    }

    /** The database server. */
    public static function mariadbd(): string
    {
        return self::program('mariadbd');
    }

    private static function program(string $name): string
    {
        $folders = [...explode(PATH_SEPARATOR, (string) getenv('PATH')), '/usr/sbin'];

        return self::first($name, array_map(static fn (string $folder): string => "$folder/$name", $folders));
    }

    /** @param list<string> $candidates */
    private static function first(string $part, array $candidates): string
    {
        foreach ($candidates as $candidate) {
            if (is_file($candidate)) {
                return $candidate;
            }
        }
        if (getenv('CI') === 'true') {
            Assert::fail("missing: $part");
        }
        Assert::markTestSkipped("missing: $part");
    }
}
