<?php

declare(strict_types=1);

namespace Msisf\Scripts\Ldem;

use Msisf\Scripts\Exception\BadInputException;

/**
 * Cuts the text of a PDS3 label (Object Description Language) into tokens, comments left out.
 * Planetary Data System Standards Reference 3.8, chapter 12.
 */
final class PdsTokenizer
{
    private const BLANKS = " \t\r\n\v\f\0";

    private int $position = 0;

    private int $line = 1;

    /**
     * @param string $text the label; what follows its END may be anything
     * @param string $file name for messages
     */
    public function __construct(private readonly string $text, private readonly string $file)
    {
    }

    /** @throws BadInputException a quotation, comment or unit has no end */
    public function next(): PdsToken
    {
        $this->skipBlanksAndComments();
        $first = $this->text[$this->position] ?? null;
        if ($first === null) {
            return new PdsToken(PdsTokenKind::End, '', $this->line);
        }

        return match ($first) {
            '"', "'" => $this->enclosed(PdsTokenKind::Quoted, $first, 'quotation'),
            '<' => $this->enclosed(PdsTokenKind::Unit, '>', 'unit'),
            '=', '(', ')', '{', '}', ',' => new PdsToken(PdsTokenKind::Sign, $this->text[$this->position++], $this->line),
            default => $this->word(),
        };
    }

    private function skipBlanksAndComments(): void
    {
        while (true) {
            $this->moveTo($this->position + strspn($this->text, self::BLANKS, $this->position));
            if (substr_compare($this->text, '/*', min($this->position, strlen($this->text)), 2) !== 0) {
                return;
            }
            $end = strpos($this->text, '*/', $this->position + 2);
            $this->moveTo($end === false ? throw $this->endless('comment') : $end + 2);
        }
    }

    private function enclosed(PdsTokenKind $kind, string $closing, string $what): PdsToken
    {
        $startLine = $this->line;
        $start = $this->position + 1;
        $end = strpos($this->text, $closing, $start);
        $this->moveTo($end === false ? throw $this->endless($what) : $end + 1);

        return new PdsToken($kind, substr($this->text, $start, $end - $start), $startLine);
    }

    private function word(): PdsToken
    {
        $length = strcspn($this->text, self::BLANKS . '"\'<=(){},', $this->position);
        $comment = strpos($word = substr($this->text, $this->position, $length), '/*');
        $word = $comment === false ? $word : substr($word, 0, $comment);
        $this->position += strlen($word);

        return new PdsToken(PdsTokenKind::Word, $word, $this->line);
    }

    private function moveTo(int $target): void
    {
        $this->line += substr_count($this->text, "\n", $this->position, $target - $this->position);
        $this->position = $target;
    }

    private function endless(string $what): BadInputException
    {
        return BadInputException::atLine($this->file, $this->line, "the $what that begins here has no end. Is this a whole PDS3 label?");
    }
}
