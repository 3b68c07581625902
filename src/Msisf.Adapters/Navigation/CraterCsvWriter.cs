using Msisf.Adapters.Catalogues;
using Msisf.Adapters.Metadata;
using Msisf.Core.Navigation;

namespace Msisf.Adapters.Navigation;

/// <summary>Writes the craters of a frame as CSV: a line each, with a heading.</summary>
public static class CraterCsvWriter
{
    private static readonly string[] Parameters = ["h", "v", "semiMajor", "semiMinor", "turn"];

    /// <summary>Writes the craters.</summary>
    /// <param name="writer">Receives the text.</param>
    /// <param name="referenceRadius">m: radius of the sphere over which heights are counted.</param>
    public static void Write(TextWriter writer, CratersOfFrame craters, double referenceRadius)
    {
        bool hasErrors = craters.Views.Any(view => view.Crater.Errors is not null);
        string[] names = [.. Names(referenceRadius)];
        writer.Write(string.Join(',', ["number", "id", "name", .. names, .. hasErrors ? CovarianceNames() : []]));
        writer.Write('\n');
        foreach (CraterView view in craters.Views)
        {
            writer.Write(string.Join(
                ',',
                [
                    view.Crater.Number.ToString(CultureInfo.InvariantCulture), CsvLine.Field(view.Crater.Identity),
                    CsvLine.Field(view.Crater.Name ?? string.Empty),
                    .. CraterFields.Of(view, referenceRadius).Select(field => CraterFields.TextOf(field.Value)),
                    .. hasErrors ? Covariances(view) : [],
                ]));
            writer.Write('\n');
        }
    }

    private static IEnumerable<string> Names(double referenceRadius) => CraterFields.Of(
        new CraterView(new Crater(1, "1", null, 0.0, 0.0, 1.0), default, default) { Inside = 0.0, Emission = 0.0, Incidence = 0.0 },
        referenceRadius).Select(field => field.Name);

    /// <summary>The upper triangle by rows: cov_h_h, cov_h_v, ...</summary>
    private static IEnumerable<string> CovarianceNames() => Triangle().Select(
        place => $"cov_{Parameters[place / Parameters.Length]}_{Parameters[place % Parameters.Length]}");

    private static IEnumerable<string> Covariances(CraterView view) =>
        Triangle().Select(place => CraterFields.TextOf(view.Covariance?[place]));

    private static IEnumerable<int> Triangle() =>
        from row in Enumerable.Range(0, Parameters.Length)
        from column in Enumerable.Range(row, Parameters.Length - row)
        select (row * Parameters.Length) + column;
}
