using Xunit;

namespace Msisf.Viewer.Tests;

/// <summary>Tests in one Chromium run one after another.</summary>
[CollectionDefinition(Chromium.Collection)]
public sealed class ChromiumCollection : ICollectionFixture<Chromium>, ICollectionFixture<ViewerServer>;
