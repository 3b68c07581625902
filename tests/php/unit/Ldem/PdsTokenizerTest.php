<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Ldem;

use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Ldem\PdsToken;
use Msisf\Scripts\Ldem\PdsTokenizer;
use Msisf\Scripts\Ldem\PdsTokenKind;
use PHPUnit\Framework\TestCase;

final class PdsTokenizerTest extends TestCase
{
    /** @dataProvider texts */
    public function testNextCutsTheTextIntoTokens(string $text, array $expected): void
    {
        self::assertSame($expected, array_map(static fn (PdsToken $token): string => "{$token->kind->name} $token->text", self::tokens($text)));
    }

    public static function texts(): array
    {
        return [
            'statement' => ['LINES = 720', ['Word LINES', 'Sign =', 'Word 720']],
            'no blanks' => ['A=(1,"b")', ['Word A', 'Sign =', 'Sign (', 'Word 1', 'Sign ,', 'Quoted b', 'Sign )']],
            'set' => ["{'x','y'}", ['Sign {', 'Quoted x', 'Sign ,', 'Quoted y', 'Sign }']],
            'unit' => ['4 <pix/deg>', ['Word 4', 'Unit pix/deg']],
            'unit without a blank' => ['4<pix/deg>', ['Word 4', 'Unit pix/deg']],
            'the other quotation mark' => ['"it\'s" \'say "x"\'', ["Quoted it's", 'Quoted say "x"']],
            'signs in quotation marks' => ['"= ( /* no comment */"', ['Quoted = ( /* no comment */']],
            'comments' => ['/* a */ A /**/ = /* b = c */ 1', ['Word A', 'Sign =', 'Word 1']],
            'comment that ends a word' => ['MOON/* Earth\'s */= 1', ['Word MOON', 'Sign =', 'Word 1']],
            'slash in a word' => ['a/b', ['Word a/b']],
            'all kinds of blanks' => ["\0\v\f\r\nA", ['Word A']],
            'nothing' => [" \r\n", []],
        ];
    }

    public function testNextNamesTheLineOfATokensFirstCharacter(): void
    {
        $tokens = self::tokens("A =\r\n/* over\r\ntwo lines */ \"over\r\ntwo\" B");

        self::assertSame(
            [['A', 1], ['=', 1], ["over\r\ntwo", 3], ['B', 4]],
            array_map(static fn (PdsToken $token): array => [$token->text, $token->line], $tokens),
        );
    }

    public function testNextAfterTheEndStaysThere(): void
    {
        $tokenizer = new PdsTokenizer("A\n", 'x.LBL');
        $tokenizer->next();

        self::assertSame([PdsTokenKind::End, PdsTokenKind::End], [$tokenizer->next()->kind, $tokenizer->next()->kind]);
    }

    /** @dataProvider endlessTexts */
    public function testNextWithoutAnEndIsRefusedWithTheLineOfTheBeginning(string $text, string $message): void
    {
        $this->expectException(BadInputException::class);
        $this->expectExceptionMessage($message);
        self::tokens($text);
    }

    public static function endlessTexts(): array
    {
        return [
            'quotation' => ["A\n= \"b\n\n", 'x.LBL, line 2: the quotation that begins here has no end'],
            'the wrong quotation mark' => ['"b\'', 'line 1: the quotation'],
            'unit' => ["\n4 <deg\n", 'line 2: the unit that begins here has no end'],
            'comment' => ["\n\n/* b\n", 'line 3: the comment that begins here has no end'],
            'comment of three characters' => ['/*/', 'line 1: the comment'],
        ];
    }

    /** @return list<PdsToken> without the one that marks the end */
    private static function tokens(string $text): array
    {
        $tokenizer = new PdsTokenizer($text, 'x.LBL');
        $tokens = [];
        while (($token = $tokenizer->next())->kind !== PdsTokenKind::End) {
            $tokens[] = $token;
        }

        return $tokens;
    }
}
