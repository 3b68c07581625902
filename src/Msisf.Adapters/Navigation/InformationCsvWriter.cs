using Msisf.Core.Sensitivity;

namespace Msisf.Adapters.Navigation;

/// <summary>Writes what an image tells of the numbers that it depends on, as CSV (docs/sensitivities.md).</summary>
public static class InformationCsvWriter
{
    /// <summary>Writes a line for each parameter and each axis of the bound. A number that is not known is an empty field.</summary>
    /// <param name="writer">Receives the text.</param>
    public static void Write(TextWriter writer, FisherInformation information)
    {
        IReadOnlyList<Parameter> parameters = information.Parameters;
        writer.Write($"row,unit,deviation,{Names("information")},{Names("covariance")}\n");
        for (int i = 0; i < parameters.Count; i++)
        {
            int row = i;
            Line(
                parameters[i].Name, parameters[i].Unit, information.DeviationOf(parameters[i]),
                Range().Select(column => (double?)information.Matrix[row, column]),
                Range().Select(column => information.Covariance[row, column]));
        }

        foreach ((ParameterKind kind, string name, string unit) in (ReadOnlySpan<(ParameterKind, string, string)>)[
            (ParameterKind.Position, "position-axis", "m"), (ParameterKind.Turn, "turn-axis", "rad")])
        {
            IReadOnlyList<(double Deviation, double X, double Y, double Z)> axes = information.AxesOf(kind);
            for (int i = 0; i < axes.Count; i++)
            {
                (double deviation, double x, double y, double z) = axes[i];
                double[] direction = [x, y, z];
                Line(
                    Invariant($"{name}-{i + 1}"), unit, deviation, Range().Select(_ => (double?)null),
                    parameters.Select(parameter => parameter.Kind == kind ? direction[parameter.Axis] : (double?)null));
            }
        }

        Line(
            Invariant($"weakest-of-rank-{information.Rank}"), string.Empty, null, Range().Select(_ => (double?)null),
            information.Weakest.Select(part => (double?)part));

        IEnumerable<int> Range() => Enumerable.Range(0, parameters.Count);

        string Names(string kind) => string.Join(',', parameters.Select(parameter => $"{kind}_{parameter.Name}"));

        void Line(string row, string unit, double? deviation, IEnumerable<double?> numbers, IEnumerable<double?> more) =>
            writer.Write($"{row},{unit},{Text(deviation)},{string.Join(',', numbers.Concat(more).Select(Text))}\n");
    }

    private static string Text(double? number) => number is { } value ? Invariant($"{value:R}") : string.Empty;
}
