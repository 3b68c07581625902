<?php

declare(strict_types=1);

namespace Msisf\Tests\Support;

/** The table of option files that the tests of msis read too. */
final class OptionFileCases
{
    private const TABLE = __DIR__ . '/../../Msisf.MySql.Tests/option_files.json';

    /** @return list<string> */
    public static function defaultSockets(): array
    {
        return self::table()['defaultSockets'];
    }

    /** @return array<string, array{string}> names of the cases that are connections, or of those that are refused, for a data provider */
    public static function names(bool $areRefused): array
    {
        $names = array_column(array_filter(self::table()['cases'], static fn (array $case): bool => isset($case['refused']) === $areRefused), 'name');

        return array_combine($names, array_map(static fn (string $name): array => [$name], $names));
    }

    /** @return array<string, mixed> */
    public static function of(string $name): array
    {
        return array_column(self::table()['cases'], null, 'name')[$name];
    }

    /** @return array<string, bool|int|string|null> the settings; the first case has those that a case leaves out */
    public static function expected(string $name): array
    {
        return [...self::table()['cases'][0]['expected'], ...self::of($name)['expected']];
    }

    /** @return array<string, mixed> */
    private static function table(): array
    {
        return json_decode((string) file_get_contents(self::TABLE), true, 512, JSON_THROW_ON_ERROR);
    }
}
