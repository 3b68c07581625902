namespace Msisf.Adapters.Ephemeris;

/// <summary>Reads text kernels: name = value, name = ( value value ... ), name += value.</summary>
/// <remarks>NAIF, Kernel Required Reading, "Text Kernel Specifications".</remarks>
public static class TextKernelReader
{
    /// <summary>Adds what a text kernel assigns to a pool.</summary>
    /// <param name="fileName">For messages.</param>
    /// <param name="pool">Receives the values.</param>
    /// <exception cref="BadInputException">Not a text kernel, or an assignment that can't be read; the message names the line.</exception>
    public static void Read(TextReader reader, string fileName, KernelPool pool)
    {
        List<TextKernelToken> tokens = TextKernelLexer.Read(reader, fileName);
        int position = 0;
        while (position < tokens.Count)
        {
            position = ReadAssignment(tokens, position, fileName, pool);
        }
    }

    private static int ReadAssignment(List<TextKernelToken> tokens, int position, string fileName, KernelPool pool)
    {
        TextKernelToken name = tokens[position];
        if (name.Kind != TextKernelTokenKind.Word)
        {
            throw new BadInputException($"{Place(fileName, name)}: {name.Value} where the name of a variable is expected.");
        }

        TextKernelTokenKind? operation = position + 1 < tokens.Count ? tokens[position + 1].Kind : null;
        if (operation is not (TextKernelTokenKind.Assign or TextKernelTokenKind.Append))
        {
            throw new BadInputException($"{Place(fileName, name)}: = or += is expected after {name.Value}.");
        }

        List<TextKernelToken> values = ValuesFrom(tokens, position + 2, name, fileName, out int next);
        KernelVariable variable = ToVariable(values, name, fileName);
        if (operation == TextKernelTokenKind.Append)
        {
            pool.Append(name.Value, variable);
        }
        else
        {
            pool.Assign(name.Value, variable);
        }

        return next;
    }

    private static List<TextKernelToken> ValuesFrom(
        List<TextKernelToken> tokens, int first, TextKernelToken name, string fileName, out int next)
    {
        bool isList = first < tokens.Count && tokens[first].Kind == TextKernelTokenKind.Open;
        List<TextKernelToken> values = [];
        next = isList ? first + 1 : first;
        while (next < tokens.Count && tokens[next].Kind is TextKernelTokenKind.Word or TextKernelTokenKind.Text
            && (isList || values.Count == 0))
        {
            values.Add(tokens[next++]);
        }

        if (values.Count == 0)
        {
            throw new BadInputException($"{Place(fileName, name)}: {name.Value} has no value.");
        }

        if (isList && (next == tokens.Count || tokens[next++].Kind != TextKernelTokenKind.Close))
        {
            throw new BadInputException($"{Place(fileName, name)}: the list of {name.Value} is not closed by ')'.");
        }

        return values;
    }

    private static KernelVariable ToVariable(List<TextKernelToken> values, TextKernelToken name, string fileName)
    {
        string source = Place(fileName, name);
        TextKernelTokenKind kind = values[0].Kind;
        double[] numbers = new double[kind == TextKernelTokenKind.Text ? 0 : values.Count];
        string[] texts = new string[values.Count - numbers.Length];
        for (int i = 0; i < values.Count; i++)
        {
            TextKernelToken value = values[i];
            if (value.Kind != kind)
            {
                throw new BadInputException($"{Place(fileName, value)}: the list of {name.Value} mixes numbers and texts.");
            }

            if (kind == TextKernelTokenKind.Text)
            {
                texts[i] = value.Value;
            }
            else if (!KernelNumber.TryParse(value.Value, out numbers[i]))
            {
                throw new BadInputException(
                    $"{Place(fileName, value)}: {name.Value} has the value {value.Value}; {KernelNumber.ValidValues} expected.");
            }
        }

        return new KernelVariable(numbers, texts, source);
    }

    private static string Place(string fileName, TextKernelToken token) => $"{fileName}, line {token.Line}";
}

/// <summary>Numbers as text kernels write them, with Fortran's exponents and with dates.</summary>
internal static class KernelNumber
{
    /// <summary>What <see cref="TryParse"/> takes, for messages.</summary>
    public static string ValidValues =>
        $"a number (1.5, 1.657D-3), a text in single quotes ('de421.bsp') or a date ({KernelDate.ValidValues})";

    /// <summary>A number, or a date as seconds past 2000-01-01T12:00:00 in days of 86 400 s.</summary>
    public static bool TryParse(string word, out double number) => word.StartsWith('@')
        ? KernelDate.TryParse(word[1..], out number)
        : double.TryParse(
            word.Replace('D', 'E').Replace('d', 'e'),
            NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint | NumberStyles.AllowExponent,
            CultureInfo.InvariantCulture,
            out number) && double.IsFinite(number);
}
