<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Console;

use Msisf\Scripts\Console\Option;
use Msisf\Scripts\Console\OptionParser;
use Msisf\Scripts\Console\ParsedOptions;
use Msisf\Scripts\Exception\UsageException;
use PHPUnit\Framework\TestCase;

final class OptionParserTest extends TestCase
{
    public function testParseBothFormsOfAValueAreRead(): void
    {
        self::assertSame('7', self::parse('--count', '7')->text('count'));
        self::assertSame('a=b', self::parse('--name=a=b')->text('name'));
        self::assertSame('-5', self::parse('--count', '-5')->text('count'));
    }

    public function testParseDefaultStandsInForAMissingOption(): void
    {
        self::assertSame(3, self::parse()->integer('count', 0, 9));
        self::assertNull(self::parse()->text('name'));
        self::assertFalse(self::parse()->has('fast'));
    }

    public function testParseAfterTwoDashesEverythingIsAnOperand(): void
    {
        self::assertSame(['a', '--fast'], self::parse('a', '--', '--fast')->operands);
    }

    /** @dataProvider wrongArguments */
    public function testParseWrongArgumentsAreRefusedByName(array $arguments, string $message): void
    {
        $this->expectException(UsageException::class);
        $this->expectExceptionMessage($message);
        self::parse(...$arguments)->integer('count', 0, 9);
    }

    public static function wrongArguments(): array
    {
        return [
            'unknown' => [['--fats'], '--fats is not an option'],
            'one dash' => [['-fast'], '-fast is not an option'],
            'abbreviated' => [['--cou=1'], '--cou is not an option'],
            'twice' => [['--fast', '--fast'], '--fast is given twice'],
            'no value' => [['--count'], '--count is missing'],
            'an option as value' => [['--count', '--fast'], '--count has no value'],
            'a flag with a value' => [['--fast=1'], '--fast=1: this option has no value'],
            'too large' => [['--count=10'], '--count=10: a whole number from 0 to 9 is needed'],
            'no number' => [['--count=1e1'], '--count=1e1: a whole number'],
            'a line end' => [["--count=1\n"], 'a whole number from 0 to 9'],
        ];
    }

    public function testHelpNamesEveryOptionAndDefault(): void
    {
        $help = self::parser()->help();
        self::assertMatchesRegularExpression('/^  --count N +How many\. \(default: 3\)$/m', $help);
        self::assertMatchesRegularExpression('/^  --help +Show this text\.$/m', $help);
    }

    private static function parse(string ...$arguments): ParsedOptions
    {
        return self::parser()->parse($arguments);
    }

    private static function parser(): OptionParser
    {
        return new OptionParser('usage', [
            Option::value('count', 'N', 'How many.', '3'),
            Option::value('name', 'TEXT', 'What.'),
            Option::flag('fast', 'Hurry.'),
        ], 'FILE');
    }
}
