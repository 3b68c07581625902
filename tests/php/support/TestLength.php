<?php

declare(strict_types=1);

namespace Msisf\Tests\Support;

/** How much of a random comparison is done: a sample every day, all of it with MSISF_LONG_TESTS=1. Either way the test runs. */
final class TestLength
{
    public static function of(int $everyDay, int $longForm): int
    {
        return getenv('MSISF_LONG_TESTS') === '1' ? $longForm : $everyDay;
    }
}
