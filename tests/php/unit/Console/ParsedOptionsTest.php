<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Console;

use LogicException;
use Msisf\Scripts\Console\Option;
use Msisf\Scripts\Console\OptionParser;
use Msisf\Scripts\Console\ParsedOptions;
use Msisf\Scripts\Exception\UsageException;
use PHPUnit\Framework\TestCase;

final class ParsedOptionsTest extends TestCase
{
    /** @dataProvider integers */
    public function testIntegerLimitsBelongToTheRange(string $written, ?int $expected): void
    {
        if ($expected === null) {
            $this->expectException(UsageException::class);
            $this->expectExceptionMessage("--count=$written: a whole number from -3 to 9 is needed");
        }
        self::assertSame($expected, self::parse("--count=$written")->integer('count', -3, 9));
    }

    public static function integers(): array
    {
        return [
            ['-3', -3], ['+9', 9], ['007', 7], ['-4', null], ['10', null], ['', null], ['1.0', null], [' 1', null], ['0x1', null],
            'more digits than a number has' => ['1234567890123456789', null],
        ];
    }

    public function testChoiceIsOneOfTheAllowedWords(): void
    {
        self::assertSame('grid', self::parse('--query=grid')->choice('query', ['grid', 'spatial']));
        self::assertSame('spatial', self::parse()->choice('query', ['grid', 'spatial']));
        $this->expectException(UsageException::class);
        $this->expectExceptionMessage('--query=GRID: one of grid, spatial is needed');
        self::parse('--query=GRID')->choice('query', ['grid', 'spatial']);
    }

    public function testRequiredTextWithoutADefaultIsAskedFor(): void
    {
        self::assertSame('', self::parse('--count=')->requiredText('count'));
        $this->expectException(UsageException::class);
        $this->expectExceptionMessage('--count is missing');
        self::parse()->requiredText('count');
    }

    /** @dataProvider readers */
    public function testOptionThatIsNotDeclaredIsABug(string $method): void
    {
        $this->expectException(LogicException::class);
        $this->expectExceptionMessage('The option --cuont is not declared.');
        self::parse()->$method('cuont');
    }

    public static function readers(): array
    {
        return [['has'], ['text'], ['requiredText']];
    }

    private static function parse(string ...$arguments): ParsedOptions
    {
        return (new OptionParser('usage', [
            Option::value('count', 'N', 'How many.'),
            Option::value('query', 'WAY', 'How.', 'spatial'),
        ]))->parse($arguments);
    }
}
