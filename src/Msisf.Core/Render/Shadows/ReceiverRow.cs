namespace Msisf.Core.Render.Shadows;

/// <summary>Receivers of one row of the picture, one element each.</summary>
/// <param name="u">Light space, m.</param>
/// <param name="v">Light space, m.</param>
/// <param name="w">Light space, m; greater is farther from the Sun.</param>
/// <param name="columns">Of the picture, from 0.</param>
internal readonly ref struct ReceiverRow(Span<double> u, Span<double> v, Span<double> w, Span<int> columns)
{
    public Span<double> U { get; } = u;

    public Span<double> V { get; } = v;

    public Span<double> W { get; } = w;

    public Span<int> Columns { get; } = columns;

    public int Count => Columns.Length;

    /// <summary>Bounds across the rays.</summary>
    public LightBox Box()
    {
        LightBox box = LightBox.Empty;
        for (int i = 0; i < Count; i++)
        {
            box = LightBox.Union(box, new LightBox(U[i], U[i], V[i], V[i]));
        }

        return box;
    }
}
