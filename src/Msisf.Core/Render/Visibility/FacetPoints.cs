namespace Msisf.Core.Render.Visibility;

/// <summary>Points of facets, each by the ray on which it lies and its depth.</summary>
internal sealed class FacetPoints
{
    private const int FirstCapacity = 1024;

    /// <summary>Number of points.</summary>
    public int Count { get; private set; }

    /// <summary>Number of each point's facet.</summary>
    public int[] Facets { get; private set; } = new int[FirstCapacity];

    /// <summary>1/m: inverse depth of each point.</summary>
    public double[] InverseDepths { get; private set; } = new double[FirstCapacity];

    /// <summary>Each point's factor of the camera's vector to the right in its ray's direction.</summary>
    public double[] Across { get; private set; } = new double[FirstCapacity];

    /// <summary>Each point's factor of the camera's vector up, with a lens of the vector down.</summary>
    public double[] Along { get; private set; } = new double[FirstCapacity];

    /// <summary>Starts without points.</summary>
    public void Clear() => Count = 0;

    /// <summary>Adds a point.</summary>
    public void Add(int facet, double inverseDepth, double across, double along)
    {
        if (Count == Facets.Length)
        {
            Grow();
        }

        Facets[Count] = facet;
        InverseDepths[Count] = inverseDepth;
        (Across[Count], Along[Count]) = (across, along);
        Count++;
    }

    /// <summary>Where a point is.</summary>
    public FacetPlace PlaceOf(int point) => new(InverseDepths[point], Across[point], Along[point]);

    /// <summary>Puts a point elsewhere on its facet.</summary>
    public void Move(int point, FacetPlace place) =>
        (InverseDepths[point], Across[point], Along[point]) = (place.InverseDepth, place.Across, place.Along);

    private void Grow()
    {
        int room = 2 * Count;
        (int[] facets, double[] depths, double[] across, double[] along) = (Facets, InverseDepths, Across, Along);
        Array.Resize(ref facets, room);
        Array.Resize(ref depths, room);
        Array.Resize(ref across, room);
        Array.Resize(ref along, room);
        (Facets, InverseDepths, Across, Along) = (facets, depths, across, along);
    }
}

/// <summary>A place on a facet; places are added and scaled to find their mean, as the inverse depth is linear in the image.</summary>
/// <param name="InverseDepth">As in <see cref="FacetPoints.InverseDepths"/>.</param>
/// <param name="Across">As in <see cref="FacetPoints.Across"/>.</param>
/// <param name="Along">As in <see cref="FacetPoints.Along"/>.</param>
internal readonly record struct FacetPlace(double InverseDepth, double Across, double Along)
{
    public static FacetPlace operator +(FacetPlace a, FacetPlace b) =>
        new(a.InverseDepth + b.InverseDepth, a.Across + b.Across, a.Along + b.Along);

    public static FacetPlace operator *(double factor, FacetPlace place) =>
        new(factor * place.InverseDepth, factor * place.Across, factor * place.Along);
}
